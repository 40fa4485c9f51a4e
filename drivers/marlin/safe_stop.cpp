#include "drivers/marlin/safe_stop.h"

#include "drivers/marlin/framing.h"

namespace slipstick {

std::string numbered_safe_stop() {
  std::string bytes = "\n" + std::string(kEndWait) + frame(0, "M110 N0");
  LineNumber number = 0;
  for (const std::string_view text : kSafeStopLines) bytes += frame(++number, text);
  return bytes;
}

}  // namespace slipstick
