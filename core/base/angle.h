#pragma once

#include "core/base/vec.h"

namespace slipstick {

/// The unit vector at `degrees` from x towards y: exact at whole quarter turns, elsewhere the same
/// bits on every machine.
[[nodiscard]] Vec2 direction_of(double degrees);

}  // namespace slipstick
