// Any bytes are a line of G-code or none, and what is read does not depend on number, checksum and
// comment.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/check.h"
#include "core/gcode/parse.h"

using namespace slipstick;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  const auto command = parse_gcode(line);
  const std::string framed = "N5 " + std::string(bare_command(line)) + " *33";
  const auto bare = parse_gcode(framed);
  SLIPSTICK_CHECK(command.has_value() == bare.has_value());
  if (!command) return 0;
  SLIPSTICK_CHECK(command->letter() == bare->letter() && command->code() == bare->code());
  for (char name = 'A'; name <= 'Z'; ++name) {
    SLIPSTICK_CHECK(command->has(name) == bare->has(name));
    SLIPSTICK_CHECK(!command->value(name) || command->has(name));
  }
  return 0;
}
