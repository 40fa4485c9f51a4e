#include "drivers/marlin/framing.h"

#include "core/base/check.h"

namespace slipstick {

std::string frame(LineNumber number, std::string_view text) {
  SLIPSTICK_CHECK(number >= 0);
  std::string line = "N" + std::to_string(number) + " ";
  line += text;
  const std::uint8_t sum = xor_checksum(line);
  line += "*" + std::to_string(sum) + "\n";
  return line;
}

}  // namespace slipstick
