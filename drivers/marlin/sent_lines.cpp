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
  const std::uint64_t before = highest_ < 0 ? 0 : ring_[slot(highest_)].job_lines;
  ++highest_;
  ring_[slot(highest_)] = {std::move(text), before + (owner == LineOwner::kJob ? 1U : 0U)};
  return highest_;
}

bool SentLines::has(LineNumber number) const {
  return number >= 0 && number <= highest_ && highest_ - number < LineNumber{kCapacity};
}

const SentLines::Entry& SentLines::at(LineNumber number) const {
  SLIPSTICK_CHECK(has(number));
  return ring_[slot(number)];
}

}  // namespace slipstick
