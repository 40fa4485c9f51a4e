#include "host/paper/slice_through.h"

#include "host/interrupt.h"

namespace slipstick {

Result<SlicingTotals> slice_through(const PlacedSolid& placed, const SlicingRequest& request) {
  auto job = SlicingJob::start(placed, request);
  if (!job) return fail(job.error());
  while (true) {
    if (Interrupt::requested()) return fail(ErrorCode::kCancelled, "interrupted");
    const auto layer = (*job)->next();
    if (!layer) return fail(layer.error());
    if (!*layer) return (*job)->totals();
  }
}

}  // namespace slipstick
