#include "sim/faults/fault_set.h"

#include <algorithm>

#include "core/base/rng.h"
#include "sim/faults/fault_names.h"

namespace slipstick {

FaultSet::FaultSet(const std::vector<FaultSpec>& specs, std::uint64_t seed) {
  Rng rng(seed);
  for (const FaultSpec& spec : specs) faults_.push_back(make_fault(spec, rng.next()));
}

void FaultSet::see(Printer& printer) {
  for (const auto& fault : faults_) fault->see(printer);
}

std::optional<Moment> FaultSet::next_at() const {
  std::optional<Moment> first;
  for (const auto& fault : faults_) {
    if (const auto at = fault->next_at()) first = first ? std::min(*first, *at) : at;
  }
  return first;
}

std::string FaultSet::to_board(std::string bytes, Moment now) {
  for (const auto& fault : faults_) bytes = fault->to_board(std::move(bytes), now);
  return bytes;
}

std::string FaultSet::to_host(std::string text, Moment now) {
  for (const auto& fault : faults_) text = fault->to_host(std::move(text), now);
  return text;
}

Moment FaultSet::delay(Moment now) const {
  Moment sum{0};
  for (const auto& fault : faults_) sum += fault->delay(now);
  return sum;
}

std::int64_t FaultSet::count() const {
  std::int64_t sum = 0;
  for (const auto& fault : faults_) sum += fault->count();
  return sum;
}

}  // namespace slipstick
