#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/slicing_job.h"

namespace slipstick {

/// The clustering ratios of the charts. The paper's text tells of its own (figs. 21 and 22, section
/// 6) that they have values on both sides of 10, and recommends 10 to 15; the scale of their axes
/// is in the drawings alone. These are ours: close round 10, and to four times that.
inline constexpr std::array<int, 9> kStudyAlphas{2, 4, 6, 8, 10, 12, 15, 25, 40};

/// What one clustering ratio leads to.
struct AlphaResult {
  int alpha = 0;
  double distortion = 0;  ///< mm³: the largest regional one, D'.
  std::size_t edges = 0;  ///< After simplification, all layers.
  double seconds = 0;     ///< To slice them, wall time.
};

/// Slices `placed` once for each of `alphas` by variational simplification (`--simplify vsa`), all
/// else as `request` says. \return errors of SlicingJob, or kCancelled.
[[nodiscard]] Result<std::vector<AlphaResult>> alpha_study(const PlacedSolid& placed,
                                                           SlicingRequest request,
                                                           std::span<const int> alphas);

/// Three charts side by side (figs. 21 c to e): distortion (in³, as there), edges and time over
/// alpha, below `title`. \return kInput if `path` is neither .svg nor .png, or nothing was studied.
[[nodiscard]] Result<void> draw_alpha_study(std::span<const AlphaResult> results,
                                            const std::string& title,
                                            const std::filesystem::path& path);

}  // namespace slipstick
