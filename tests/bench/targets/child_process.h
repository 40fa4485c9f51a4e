#pragma once

#include <functional>

namespace slipstick::targets {

/// Runs `measure` in a process of its own and gives its result: what an allocator has kept from
/// before does not count there.
[[nodiscard]] double in_child(const std::function<double()>& measure);

}  // namespace slipstick::targets
