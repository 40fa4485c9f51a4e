#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/image/bit_image.h"

namespace slipstick {

/// The layer of a model that is being printed, as the lines that were made of it.
struct PrintedLayer {
  /// Points told of one layer; what comes behind them is left out.
  static constexpr int kPointsMax = 40'000;

  int layer = 0;      ///< From 1, as PrinterStatus::layer.
  double height = 0;  ///< mm: its top.
  std::int64_t lines_before =
      0;  ///< What PrinterStatus::lines is when its first line begins; may be negative.
  std::int64_t lines = 0;                           ///< It has.
  std::string program;                              ///< Its G-code, as `write_layer` makes it.
  std::shared_ptr<const BitImage> image = nullptr;  ///< What it is made of.
};

/// How many lines of `program` are no comments.
[[nodiscard]] std::int64_t lines_of_layer(const std::string& program);

/// How much of `layer` is done, 0 to 1, once `lines` of the print are acknowledged.
[[nodiscard]] double share_done(const PrintedLayer& layer, std::int64_t lines);

/// Where plastic is laid, as JSON:
///
///     {"layer": 3, "height": 0.6, "lines_before": 120, "lines": 80, "complete": true,
///      "paths": [{"line": 5, "points": [[x0, y0], [x1, y1], …]}, …]}
///
/// mm on the bed, to 0.01. The k-th piece of a path, from point k to k + 1, is made by line
/// `line` + k of the layer, from 0.
[[nodiscard]] std::string to_json_text(const PrintedLayer& layer);

}  // namespace slipstick
