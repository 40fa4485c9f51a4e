#pragma once

namespace slipstick {

/// Memory of this process, MB: gives back what is free, and forgets its peak. \return what it holds
/// now.
double begin_peak_anew();
/// What this process holds now, MB.
[[nodiscard]] double resident_mb();
/// Its peak since then.
[[nodiscard]] double peak_mb();

}  // namespace slipstick
