#pragma once

#include <vector>

#include "core/contour/certify.h"

namespace slipstick {

/// A square of the lattice, by its lower left node, where a slab may hold an event.
struct EventSquare {
  int column = 0;
  int row = 0;
  double low = 0;  ///< mm: the part of the slab that it is about.
  double high = 0;
};

/// One event for each set of squares that hang together by sides or corners.
/// \pre No square is given twice.
[[nodiscard]] std::vector<SlabEvent> merged(std::vector<EventSquare> squares, SlabEvent::Kind kind,
                                            const SliceGrid& grid);

}  // namespace slipstick
