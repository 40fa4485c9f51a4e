#pragma once

#include <filesystem>

#include "host/slicing_job.h"

namespace slipstick {

/// At most so many layers are drawn, spread evenly over the job.
inline constexpr int kStackLayersMax = 400;

/// Contours of all layers seen from obliquely above (figs. 15 d, 21 b and 22 b of the paper): each
/// filled, holes left open, lighter the higher, from the lowest up, so that what is nearer hides
/// what is behind.
///
/// Takes all layers of `job`. \param side the longest side of the picture but for a margin, in its
/// units. \return kInput if they are all empty; kCancelled; errors of the job.
[[nodiscard]] Result<void> draw_stack(SlicingJob& job, int side, const std::filesystem::path& path);

}  // namespace slipstick
