#pragma once

#include <span>

#include "core/image/bit_image.h"

namespace slipstick::test {

/// Betti numbers: how many components, tunnels and cavities.
struct Betti {
  int components = 0;
  int tunnels = 0;
  int cavities = 0;

  friend bool operator==(const Betti&, const Betti&) = default;
};

/// Those of a stack of images, one node apart, by flood fill (6 neighbours inside, 26 outside) and
/// Euler's number. \pre All on one grid.
[[nodiscard]] Betti betti_of(std::span<const BitImage> stack);

}  // namespace slipstick::test
