#pragma once

#include "host/slicing_job.h"

namespace slipstick {

/// Slices all layers that are asked for and keeps only what they add up to.
/// \return kCancelled when interrupted; errors of SlicingJob.
[[nodiscard]] Result<SlicingTotals> slice_through(const PlacedSolid& placed,
                                                  const SlicingRequest& request);

}  // namespace slipstick
