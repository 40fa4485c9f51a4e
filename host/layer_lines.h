#pragma once

#include <functional>
#include <string>

#include "host/line_source.h"
#include "host/slicing_job.h"

namespace slipstick {

/// The lines of a print that is sliced while it is sent: the printer's start, layers as they come,
/// the end.
class LayerLines final : public LineSource {
 public:
  /// Called with each layer just before its first line is given out.
  using OnLayer = std::function<void(const SlicedLayer&)>;

  /// Asked once before each layer, if at all: whether the print is to be paused there.
  using PauseBefore = std::function<bool(int layer)>;

  /// What comes first: the printer's start, or at once the job's first layer.
  enum class Beginning { kStart, kLayer };

  LayerLines(SlicingJob& job, const PrintSettings& settings, OnLayer on_layer,
             Beginning beginning = Beginning::kStart);

  [[nodiscard]] Result<std::optional<Line>> next() override;
  [[nodiscard]] bool ready() const override;
  [[nodiscard]] bool take_pause() override;
  void pause_before(PauseBefore which) { pause_before_ = std::move(which); }

 private:
  enum class Stage { kLayers, kEnd, kOver };

  std::optional<std::string_view> next_text();
  [[nodiscard]] Result<void> refill();

  SlicingJob& job_;
  const PrintSettings& settings_;
  const OnLayer on_layer_;
  PauseBefore pause_before_;
  Stage stage_ = Stage::kLayers;
  std::string text_;    // of the start, one layer or the end
  std::size_t at_ = 0;  // what of it was given out
  int next_layer_;
  bool asked_ = false;  // about pausing before that layer
};

}  // namespace slipstick
