#include "sim/curves.h"

#include <algorithm>
#include <cmath>

namespace slipstick {

namespace {

/// As the later one, but for what adds up.
Curves::Sample together(const Curves::Sample& a, const Curves::Sample& b) {
  Curves::Sample both = b;
  both.way += a.way;
  both.speed_max = std::max(a.speed_max, b.speed_max);
  return both;
}

}  // namespace

void Curves::halve() {
  span_seconds_ *= 2;
  const std::size_t pairs = samples_.size() / 2;
  for (std::size_t i = 0; i < pairs; ++i) {
    samples_[i] = together(samples_[2 * i], samples_[2 * i + 1]);
  }
  if (samples_.size() % 2 == 1) samples_[pairs] = samples_.back();
  samples_.resize(pairs + samples_.size() % 2);
}

Curves::Sample& Curves::at(double seconds) {
  while (seconds >= span_seconds_ * static_cast<double>(kSamplesMax)) halve();
  const auto index = static_cast<std::size_t>(std::max(0.0, seconds) / span_seconds_);
  while (samples_.size() <= index) {
    Sample next = samples_.empty() ? Sample() : samples_.back();
    next.way = next.speed_max = 0;
    samples_.push_back(next);
  }
  return samples_[index];
}

void Curves::see(Moment now, const Machine& machine) {
  Sample& sample = at(std::chrono::duration<double>(now).count());
  sample.nozzle = machine.nozzle.celsius();
  sample.nozzle_target = machine.nozzle.target();
  sample.bed = machine.bed.celsius();
  sample.bed_target = machine.bed.target();
}

void Curves::add(const ExecutedMove& move) {
  const double way = length((move.to - move.from).xyz());
  const double seconds = move.end_seconds - move.start_seconds;
  if (way <= 0 || seconds <= 0) return;
  at(move.end_seconds);  // From here on the spans are long enough, and powers of two: this ends.
  for (double from = move.start_seconds; from < move.end_seconds;) {
    const double end_of_span = (std::floor(from / span_seconds_) + 1) * span_seconds_;
    const double to = std::min(move.end_seconds, end_of_span);
    Sample& sample = at(from);
    sample.way += way * (to - from) / seconds;
    sample.speed_max = std::max(sample.speed_max, way / seconds);
    from = to;
  }
}

}  // namespace slipstick
