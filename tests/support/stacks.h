#pragma once

#include <functional>
#include <vector>

#include "core/base/affine.h"
#include "core/contour/ledger.h"
#include "core/image/bit_image.h"

namespace slipstick::test {

/// Layers of a print, bottom to top.
using Stack = std::vector<BitImage>;

/// `n` layers of n × n nodes: those at which `inside` is true. x, y and z run over the middles of
/// cells of [-1, 1]³.
[[nodiscard]] Stack stack_of(int n, const std::function<bool(Vec3)>& inside);

/// The ledger of a whole stack.
[[nodiscard]] Topology ledger_of(const Stack& stack, Ambiguity ambiguity);

/// The same by flood fill in space and by counting each corner, edge, side and cube of the solid
/// once: the slow oracle.
[[nodiscard]] Topology flooded(const Stack& stack, Ambiguity ambiguity);

}  // namespace slipstick::test
