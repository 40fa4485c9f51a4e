#pragma once

#include <string>

#include "host/sliced_layer.h"

namespace slipstick {

/// The contours of one layer as a line of JSON (docs/FORMATS.md), with its newline. Reading the
/// numbers back gives the very points that were verified.
[[nodiscard]] std::string contours_line(const SlicedLayer& layer);

}  // namespace slipstick
