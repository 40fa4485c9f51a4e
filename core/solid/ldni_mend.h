#pragma once

#include <cstdint>
#include <span>

#include "core/solid/ldni.h"

namespace slipstick {

/// Rays that did not close.
struct LdniMended {
  std::int64_t copied = 0;  ///< Taken from a neighbour.
  std::int64_t lost = 0;    ///< Left empty: no ray nearby closes. The other two axes have them.

  friend bool operator==(const LdniMended&, const LdniMended&) = default;
};

/// Fills the empty rays in `open` (in order) from the nearest ray that is not among them, within
/// three widths each way.
LdniMended mend(LdniRays& rays, const LdniGrid& grid, std::span<const std::size_t> open);

}  // namespace slipstick
