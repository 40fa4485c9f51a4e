#include "sim/faults/fault_set.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/faults/fault_names.h"

namespace slipstick {

FaultSet::FaultSet(const std::vector<FaultSpec>& specs, std::uint64_t seed) : rng_(seed) {
  for (const FaultSpec& spec : specs) faults_.push_back(make_fault(spec, rng_.next()));
}

Result<void> FaultSet::add(const FaultSpec& spec) {
  std::erase_if(faults_, [this](const auto& fault) {
    if (fault->over()) past_ += fault->count();
    return fault->over();
  });
  if (faults_.size() >= kMost) {
    return fail(ErrorCode::kInput, fmt::format("there are {} faults already; mend them", kMost));
  }
  faults_.push_back(make_fault(spec, rng_.next()));
  return {};
}

void FaultSet::mend(Printer& printer) {
  for (const auto& fault : faults_) fault->end(printer);
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
  std::int64_t sum = past_;
  for (const auto& fault : faults_) sum += fault->count();
  return sum;
}

}  // namespace slipstick
