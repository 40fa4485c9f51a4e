#pragma once

#include <cstdint>
#include <string_view>

namespace slipstick {

/// What a text of the printer says of a command that it acknowledged all the same.
enum class Objection : std::uint8_t {
  kNone,
  kUnknown,  ///< It does not know the command, or noise had made another of it.
  kNotDone,  ///< It left out what makes the part: plastic, a move, a change of tool.
};

[[nodiscard]] Objection objection_in(std::string_view text);

}  // namespace slipstick
