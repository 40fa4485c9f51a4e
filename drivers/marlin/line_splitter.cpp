#include "drivers/marlin/line_splitter.h"

#include <utility>

namespace slipstick {

std::optional<std::string_view> LineSplitter::next() {
  if (std::exchange(handed_over_, false)) partial_.clear();
  while (!bytes_.empty()) {
    const char byte = bytes_.front();
    bytes_.remove_prefix(1);
    if (byte == '\n' || byte == '\r') {
      const bool skipped = std::exchange(skipping_, false);
      if (skipped || partial_.empty()) continue;
      handed_over_ = true;
      return partial_;
    }
    if (byte == '\0' || skipping_) continue;
    partial_ += byte;
    if (partial_.size() > kMaxLine) {
      partial_.clear();
      skipping_ = true;
      ++overlong_;
    }
  }
  return std::nullopt;
}

}  // namespace slipstick
