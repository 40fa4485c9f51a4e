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

  /// What comes first: the printer's start, or at once the job's first layer.
  enum class Beginning { kStart, kLayer };

  LayerLines(SlicingJob& job, const PrintSettings& settings, OnLayer on_layer,
             Beginning beginning = Beginning::kStart);

  [[nodiscard]] Result<std::optional<Line>> next() override;
  [[nodiscard]] bool ready() const override;

 private:
  enum class Stage { kLayers, kEnd, kOver };

  [[nodiscard]] std::optional<std::string_view> next_text();
  [[nodiscard]] Result<void> refill();

  SlicingJob& job_;
  const PrintSettings& settings_;
  const OnLayer on_layer_;
  Stage stage_ = Stage::kLayers;
  std::string text_;    // of the start, one layer or the end
  std::size_t at_ = 0;  // what of it was given out
};

}  // namespace slipstick
