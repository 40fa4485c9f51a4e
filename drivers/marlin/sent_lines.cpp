#include "drivers/marlin/sent_lines.h"

#include <utility>

#include "core/base/check.h"

namespace slipstick {
namespace {

std::size_t slot(LineNumber number) {
  return static_cast<std::size_t>(number) % SentLines::kCapacity;
}

}  // namespace

LineNumber SentLines::bind(std::string text, LineOwner owner) {
  const std::uint64_t before = highest_ < first_ ? 0 : ring_[slot(highest_)].job_lines;
  const Position& after = tracker_.follow(text);
  ++highest_;
  const std::uint64_t lines = before + (owner == LineOwner::kJob ? 1U : 0U);
  ring_[slot(highest_)] = {std::move(text), lines, after, owner};
  return highest_;
}

void SentLines::insert_question(LineNumber number, std::string text) {
  SLIPSTICK_CHECK(has(number - 1) && has(number));
  ++highest_;
  for (LineNumber at = highest_; at > number; --at)
    ring_[slot(at)] = std::move(ring_[slot(at - 1)]);
  const Entry& before = ring_[slot(number - 1)];
  ring_[slot(number)] = {std::move(text), before.job_lines, before.after};
}

void SentLines::settle(LineNumber number) {
  SLIPSTICK_CHECK(has(number));
  ring_[slot(number)].text = "M105";
}

void SentLines::learn(LineNumber number, const Position& report) {
  if (number != highest_) return;
  tracker_.learn(report);
  ring_[slot(number)].after = tracker_.position();
}

bool SentLines::has(LineNumber number) const {
  return number >= first_ && number <= highest_ && highest_ - number < LineNumber{kCapacity};
}

const SentLines::Entry& SentLines::at(LineNumber number) const {
  SLIPSTICK_CHECK(has(number));
  return ring_[slot(number)];
}

}  // namespace slipstick
