#pragma once

#include "core/base/result.h"
#include "core/image/bit_image.h"
#include "core/solid/solid.h"

namespace slipstick {

/// Samples `section` at every node of `grid` (paper, section 3.1).
///
/// Tiles that the section knows to be all inside or all outside are not sampled; the image is the
/// same bit for bit as if every node had been. The outermost ring must be outside by the choice of
/// the grid and is left so.
///
/// \return kInput if f was NaN at a node; the message says where.
[[nodiscard]] Result<BitImage> sample(Section& section, const SliceGrid& grid);

}  // namespace slipstick
