#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/job/settings.h"
#include "host/journal.h"
#include "host/resume_point.h"
#include "host/settings_timeline.h"
#include "host/stream_job.h"
#include "host/tracked_lines.h"

namespace slipstick {

/// A print and its journal: kept from the beginning, or gone on with; or none at all.
///
/// In this order: `identify`, of a model `keep`, `find` with an open port, `begin` with the lines,
/// `ended`.
class JournalledPrint {
 public:
  JournalledPrint() = default;
  /// A new one, at `path`. The checksums of `header` are filled in.
  JournalledPrint(std::filesystem::path path, JournalHeader header)
      : path_(std::move(path)), header_(std::move(header)) {}
  /// One that was cut off.
  JournalledPrint(std::filesystem::path path, JournalContent content, Consent consent)
      : path_(std::move(path)), content_(std::move(content)), consent_(consent) {}

  [[nodiscard]] bool resumes() const { return content_.has_value(); }

  /// \return kInput if the model or the settings are not those of the print that was cut off.
  [[nodiscard]] Result<void> identify(const std::filesystem::path& model,
                                      const PrintSettings& settings);

  /// Layers have the settings of `timeline`: what the journal tells of changes is done again, and
  /// others are written down before the first layer that has them.
  /// \return kInput if it tells what cannot be.
  [[nodiscard]] Result<void> keep(std::shared_ptr<SettingsTimeline> timeline);

  /// Begins the journal; or asks the printer where it stands.
  /// \return as Journal::create, resume_point.
  [[nodiscard]] Result<void> find(Transport& transport, const Clock& clock);

  /// The layer whose lines `begin` is to be given first; none: all lines of the print.
  [[nodiscard]] std::optional<LayerMark> first_layer() const;

  /// Takes `source` to where the print goes on, and tells `options` how, and who keeps the journal:
  /// it must not outlive this, nor `clock`.
  /// \return what to send. kInput as resume_start, or if the layer is not what it was.
  [[nodiscard]] Result<LineSource*> begin(LineSource& source, const Clock& clock,
                                          StreamOptions& options);

  /// The next line is the first of `layer`, whose G-code is `program`.
  void began(int layer, std::string_view program);

  void ended(const Result<StreamOutcome>& outcome);

 private:
  [[nodiscard]] Result<void> go_on(StreamOptions& options);
  void write_changes();
  [[nodiscard]] std::vector<Line> board_settings() const;

  std::filesystem::path path_;
  std::optional<JournalHeader> header_;    ///< Of a new one.
  std::optional<JournalContent> content_;  ///< Of one that was cut off.
  Consent consent_ = Consent::kNone;
  ResumePoint point_;
  std::optional<TrackedLines> lines_;
  std::optional<Journal> journal_;
  std::shared_ptr<SettingsTimeline> timeline_;
  std::size_t changes_written_ = 0;
  int layer_ = -1;  ///< The last that began.
  bool same_layer_ = true;
  std::string start_;  ///< The G-code before the first layer, if there are layers.
};

}  // namespace slipstick
