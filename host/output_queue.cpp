#include "host/output_queue.h"

namespace slipstick {

Result<void> OutputQueue::write() {
  const Moment now = clock_.now();
  while (!pending_.empty()) {
    const auto count = transport_.write_some(pending_, Moment::zero());
    if (!count) {
      const bool full = count.error().code == ErrorCode::kTimedOut;
      if (full && now - progress_at_ < kStallMax) return {};
      return fail(count.error());
    }
    pending_.erase(0, *count);
    progress_at_ = now;
  }
  progress_at_ = now;
  return {};
}

void OutputQueue::clear() {
  pending_.clear();
  transport_.discard_output();
  progress_at_ = clock_.now();
}

}  // namespace slipstick
