#include "drivers/marlin/patience.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace slipstick {
namespace {

constexpr std::array kBlockingG{4, 12, 26, 28, 29, 30, 32, 33, 34, 35, 38, 76, 425};
constexpr std::array kBlockingM{0,   1,   25,  48,  109, 116, 125, 190, 191,
                                192, 226, 303, 400, 500, 501, 502, 504, 600,
                                601, 603, 701, 702, 916, 917, 918, 997, 999};

}  // namespace

bool is_blocking(std::string_view text) {
  if (text.empty()) return false;
  if (text.front() == 'T') return true;
  int code = -1;
  std::from_chars(text.data() + 1, text.data() + text.size(), code);
  if (text.front() == 'G') return std::ranges::binary_search(kBlockingG, code);
  return text.front() == 'M' && std::ranges::binary_search(kBlockingM, code);
}

}  // namespace slipstick
