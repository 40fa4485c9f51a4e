#include "host/tracked_lines.h"

#include <fmt/format.h>

namespace slipstick {

Result<std::optional<Line>> TrackedLines::next() {
  auto line = source_.next();
  if (!line || !*line) return line;
  state_.follow((**line).text());
  settings_.follow(**line);
  ++line_;
  return line;
}

Result<void> TrackedLines::skip_to(std::uint64_t line) {
  while (line_ < line) {
    const auto skipped = next();
    if (!skipped) return fail(skipped.error());
    if (!*skipped) {
      return fail(ErrorCode::kInput,
                  fmt::format("the print has {} lines, and {} were printed: it is another one",
                              line_, line));
    }
  }
  return {};
}

}  // namespace slipstick
