#pragma once

#include <cstdint>

namespace slipstick {

/// How two solids are joined: what is in either, in both, in the first without the second.
enum class Boolean : std::uint8_t { kUnion, kIntersection, kDifference };

}  // namespace slipstick
