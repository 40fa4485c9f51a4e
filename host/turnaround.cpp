#include "host/turnaround.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace slipstick {

void Turnaround::answered(Moment now) {
  if (!heard_) return;
  const Moment took = std::clamp(now - *heard_, Moment(0), kLongest);
  ++counts_[bucket_of(static_cast<std::uint64_t>(took.count()))];
  ++count_;
  heard_.reset();
}

Moment Turnaround::within(double share) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
  std::uint64_t sum = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    sum += counts_[bucket];
    if (sum > 0 && sum >= wanted) return end_of(bucket);
  }
  return Moment(0);
}

// Up to 2 * kSteps one bucket a microsecond; from there kSteps buckets for each further bit.
std::size_t Turnaround::bucket_of(std::uint64_t microseconds) {
  if (microseconds < 2 * kSteps) return microseconds;
  const auto shift = static_cast<unsigned>(std::bit_width(microseconds / kSteps) - 1);
  return shift * kSteps + (microseconds >> shift);
}

Moment Turnaround::end_of(std::size_t bucket) {
  if (bucket < 2 * kSteps) return Moment(static_cast<Moment::rep>(bucket));
  const std::size_t shift = bucket / kSteps - 1;
  const std::size_t begin = (bucket - shift * kSteps) << shift;
  return Moment(static_cast<Moment::rep>(begin + (std::size_t{1} << shift) - 1));
}

}  // namespace slipstick
