#include "sim/byte_pipe.h"

#include <algorithm>

namespace slipstick {

namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::int64_t kNsPerUs = 1'000;
/// Bytes already taken are removed from the front of the buffer when there are so many.
constexpr std::size_t kCompactAt = 1 << 16;

std::int64_t to_ns(Moment m) {
  return m.count() * kNsPerUs;
}
Moment rounded_up(std::int64_t ns) {
  return Moment((ns + kNsPerUs - 1) / kNsPerUs);
}

}  // namespace

std::int64_t BytePipe::duration_ns(std::int64_t bytes) const {
  return paced() ? bytes * kBitsPerByte * kNsPerSecond / baud_ : 0;
}

void BytePipe::push(std::string_view bytes, Moment at) {
  const std::size_t before = bytes_.size();
  if (faults_.harmless()) {
    bytes_.append(bytes);
  } else {
    bytes_ += faults_.damaged(bytes);
  }
  const auto count = static_cast<std::int64_t>(bytes_.size() - before);
  if (count == 0) return;
  const std::int64_t start = std::max(idle_ns_, to_ns(at));
  idle_ns_ = start + duration_ns(count);
  bursts_.push_back({start, 0, count});
}

std::optional<Moment> BytePipe::next_at() const {
  if (bursts_.empty()) return std::nullopt;
  const Burst& burst = bursts_.front();
  const Moment there = rounded_up(burst.start_ns + duration_ns(burst.taken + 1));
  return tick_ > Moment(0) ? (there + tick_ - Moment(1)) / tick_ * tick_ : there;
}

Moment BytePipe::idle_at() const {
  return rounded_up(idle_ns_);
}

std::int64_t BytePipe::arrived(const Burst& burst, Moment by) const {
  const std::int64_t elapsed = to_ns(by) - burst.start_ns;
  if (elapsed < 0) return burst.taken;
  if (!paced() || elapsed >= duration_ns(burst.count)) return burst.count;
  std::int64_t n = elapsed * baud_ / (kBitsPerByte * kNsPerSecond);
  while (duration_ns(n + 1) <= elapsed) ++n;  // At most once: both divisions round down.
  return std::max(n, burst.taken);
}

void BytePipe::clear() {
  bytes_.clear();
  head_ = 0;
  bursts_.clear();
}

std::size_t BytePipe::take(std::span<char> buffer, Moment by) {
  if (tick_ > Moment(0)) by = by / tick_ * tick_;
  std::size_t count = 0;
  while (!bursts_.empty() && count < buffer.size()) {
    Burst& burst = bursts_.front();
    const std::int64_t ready = arrived(burst, by) - burst.taken;
    if (ready <= 0) break;
    const std::size_t n = std::min(static_cast<std::size_t>(ready), buffer.size() - count);
    std::copy_n(bytes_.data() + head_, n, buffer.data() + count);
    head_ += n;
    count += n;
    burst.taken += static_cast<std::int64_t>(n);
    if (burst.taken == burst.count) bursts_.pop_front();
  }
  if (bursts_.empty() || head_ >= kCompactAt) {
    bytes_.erase(0, head_);
    head_ = 0;
  }
  return count;
}

}  // namespace slipstick
