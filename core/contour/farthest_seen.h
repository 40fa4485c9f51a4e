#pragma once

#include <cstddef>

#include "core/contour/corridor.h"

namespace slipstick {

/// The last stick up to `limit` whose own place is seen from that of stick `from` through the
/// windows between. Sticks are counted round and round. \pre from < limit.
[[nodiscard]] std::size_t farthest_seen(const Corridor& corridor, std::size_t from,
                                        std::size_t limit);

}  // namespace slipstick
