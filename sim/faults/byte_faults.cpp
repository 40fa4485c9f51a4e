#include "sim/faults/byte_faults.h"

#include <string_view>

namespace slipstick {

std::string ByteFault::to_board(std::string bytes, Moment now) {
  return side_ == WireSide::kToBoard && active(now) ? damaged(bytes) : bytes;
}

std::string ByteFault::to_host(std::string text, Moment now) {
  return side_ == WireSide::kToHost && active(now) ? damaged(text) : text;
}

std::string ByteFault::damaged(std::string_view bytes) {
  std::string arrived;
  for (const char byte : bytes) {
    const bool hit = rng_.unit() < share_;
    if (hit) harm();
    if (!hit) {
      arrived += byte;
    } else if (kind_ == Kind::kFlipped) {
      arrived += static_cast<char>(byte ^ (1 << rng_.below(8)));
    } else if (kind_ == Kind::kDoubled) {
      arrived.append(2, byte);
    }
  }
  return arrived;
}

}  // namespace slipstick
