#include "sim/faults/line_faults.h"

#include <algorithm>
#include <utility>

namespace slipstick {

std::string LineFault::to_board(std::string bytes, Moment now) {
  if (side_ != WireSide::kToBoard) return bytes;
  half_ += bytes;
  if (!active(now)) return std::exchange(half_, {});
  const std::size_t end = half_.rfind('\n') + 1;  // 0 where there is none
  const std::string lines = half_.substr(0, end);
  half_.erase(0, end);
  return damaged(lines);
}

std::string LineFault::to_host(std::string text, Moment now) {
  return side_ == WireSide::kToHost && active(now) ? damaged(text) : text;
}

bool LineFault::is_meant(std::string_view line) const {
  if (which_ == Which::kOk) return line.starts_with("ok");
  return which_ == Which::kAll || line.find("Resend:") != std::string_view::npos;
}

std::string LineFault::damaged(std::string_view text) {
  std::string arrived;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string line(text.substr(0, end));
    text.remove_prefix(end);
    const bool hit = is_meant(line) && rng_.unit() < share_;
    if (hit) harm();
    arrived += hit ? damaged_line(std::move(line)) : line;
  }
  return arrived;
}

std::string LineFault::damaged_line(std::string line) {
  switch (kind_) {
    case Kind::kLost:
      return {};
    case Kind::kDoubled:
      return line + line;
    case Kind::kGarbled:
      for (char& byte : line) byte = static_cast<char>(rng_.below(256));
      line.back() = '\n';
      return line;
    case Kind::kGlued:
      line.pop_back();
      return line;
    case Kind::kMisnumbered:
      break;
  }
  const std::size_t digit = line.find_first_of("0123456789");
  if (digit != std::string::npos)
    line[digit] =
        static_cast<char>('0' + (line[digit] - '0' + 1 + static_cast<int>(rng_.below(9))) % 10);
  return line;
}

}  // namespace slipstick
