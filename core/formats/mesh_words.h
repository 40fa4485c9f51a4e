#pragma once

#include <optional>
#include <string_view>

#include "core/base/vec.h"

namespace slipstick {

/// \file
/// Lines and words of text formats, taken off the front of what is left.

/// The next line without its end, "\n" or "\r\n". Nothing when `rest` is empty.
[[nodiscard]] std::optional<std::string_view> take_line(std::string_view& rest);

/// The next word; empty when only white space is left.
[[nodiscard]] std::string_view take_word(std::string_view& rest);

/// The next three words as a point. Nothing unless they are finite numbers.
[[nodiscard]] std::optional<Vec3> take_point(std::string_view& rest);

}  // namespace slipstick
