#pragma once

#include <functional>

namespace slipstick::targets {

/// Memory of this process, MB: forgets its peak. \return What it holds now.
double begin_peak_anew();
/// Its peak since then.
[[nodiscard]] double peak_mb();

/// Runs `measure` in a process of its own and gives its result: what an allocator has kept from
/// before does not count there.
[[nodiscard]] double in_child(const std::function<double()>& measure);

}  // namespace slipstick::targets
