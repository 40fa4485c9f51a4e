#pragma once

namespace slipstick {

/// From now on what is freed is kept for what is asked for next, up to some megabytes: layers take
/// as much as the one before freed, and pages fresh from the kernel cost up to a third of the time
/// of a layer's contours.
void keep_freed_memory();
/// What is kept goes back: nothing is sliced for a while.
void give_back_freed_memory();

/// Memory of this process, MB: gives back what is free, and forgets its peak. \return what it holds
/// now.
double begin_peak_anew();
/// What this process holds now, MB.
[[nodiscard]] double resident_mb();
/// Its peak since then.
[[nodiscard]] double peak_mb();

}  // namespace slipstick
