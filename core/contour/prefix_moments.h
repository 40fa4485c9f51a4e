#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/contour/corridor.h"
#include "core/contour/wedge.h"

namespace slipstick {

/// Sums over the edges of a loop from its first vertex on, so that the distortion D' (paper,
/// equation 5) of any run of edges from a line costs a few operations.
///
/// D' = n·M·n - 2c n·S + c² W for the line n·p = c, with W, S and M the integrals of 1, p and p pᵀ
/// over the run. Coordinates are cells from the first vertex: with sums up to 10^4 cells long D' is
/// good to about 10^-8 cubic cells.
class PrefixMoments {
 public:
  /// Of the corridor's own places, from stick `start` once round.
  void build(const Corridor& corridor, std::size_t start);

  /// Cubic cells: of the run from the `from`-th to the `to`-th vertex after the start, from the
  /// line through two points, which are in 1/65536 of a cell from the first vertex. Never negative.
  [[nodiscard]] double distortion(std::size_t from, std::size_t to, Ray<double> a,
                                  Ray<double> b) const;

 private:
  struct Sum {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  std::vector<Sum> sums_;
};

}  // namespace slipstick
