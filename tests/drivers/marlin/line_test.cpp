#include "drivers/marlin/line.h"

#include <catch2/catch.hpp>

#include "drivers/marlin/framing.h"
#include "drivers/marlin/patience.h"

namespace slipstick {
namespace {

std::string normalised(std::string_view raw) {
  const auto line = normalise(raw);
  if (!line) return "error: " + line.error().message;
  return *line ? (*line)->text() : "";
}

TEST_CASE("A frame is the number, the text and the XOR that Marlin 2.1.2 accepted") {
  CHECK(frame(0, "M110 N0") == "N0 M110 N0*125\n");
  CHECK(frame(1, "M105") == "N1 M105*38\n");
  CHECK(frame(2, "M105") == "N2 M105*37\n");
  CHECK(frame(29, "G1 X15 F600") == "N29 G1 X15 F600*63\n");
}

TEST_CASE("XOR cannot see two bytes exchanged: documented, not wished for") {
  CHECK(xor_checksum("N7 G1 X12") == xor_checksum("N7 G1 X21"));
}

TEST_CASE("Normalising keeps the command and nothing else") {
  CHECK(normalised("G1 X10 Y-2.5 E.003") == "G1 X10 Y-2.5 E.003");
  CHECK(normalised("  G1   X10\tY2 ; to the corner\r\n") == "G1 X10 Y2");
  CHECK(normalised("G1 (fast) X10") == "G1 X10");
  CHECK(normalised("G1 X10 (never closed") == "G1 X10");
  CHECK(normalised("N12 G1 X10*71") == "G1 X10");
  CHECK(normalised("; only words") == "");
  CHECK(normalised(" \t\r\n") == "");
  CHECK(normalised("") == "");
}

TEST_CASE("What firmware would misread is refused with the reason") {
  CHECK(Line::make("M117 a*b").error().message ==
        "G-code line 'M117 a*b': byte 0x2a at column 7 cannot be sent to a printer");
  for (const std::string_view bad : {"", " G1", "G1 ", "M117 \"x\"", "M117 a\\b", "G1 ;c", "G1 (c)",
                                     "M117 Gr\xc3\xb6sse", "G1\n", "M110 N5", "M117 see M110"}) {
    INFO(bad);
    CHECK_FALSE(Line::make(bad));
  }
}

TEST_CASE("The longest line still fits into Marlin's 95 bytes with the greatest number") {
  const std::string longest(Line::kMaxText, 'x');

  REQUIRE(Line::make(longest));
  CHECK_FALSE(Line::make(longest + "x"));
  CHECK(frame(999'999'999, longest).size() - 1 <= 95);
}

TEST_CASE(
    "A line that is too long is said in fewer bytes, where that changes nothing to speak of") {
  CHECK(normalised("G1 X100.123456789012345 Y-200.987654321098765 Z0.300000000000000 "
                   "E12345.678901234567 F1800") ==
        "G1 X100.12346 Y-200.98765 Z0.3 E12345.6789 F1800");
  CHECK(
      normalised("G1X1.00000000000000000000000Y2.0000000000000000000000000000Z3.000000000000000E-."
                 "123456789") == "G1X1Y2Z3E-0.12346");
  const std::string message = "M117 " + std::string(74, 'a') + " " + std::string(40, 'b');
  CHECK(normalised(message) == message.substr(0, 79));
}

TEST_CASE("A line that fits keeps every decimal, and one that cannot be shortened is refused") {
  CHECK(normalised("G1 X1.123456789") == "G1 X1.123456789");
  CHECK(normalised("M32 " + std::string(90, 'x')).starts_with("error: "));
  CHECK(normalised("G1 " + std::string(90, '1')).starts_with("error: "));
}

TEST_CASE("A command is known by its whole code") {
  CHECK(is_command("M105", "M105"));
  CHECK(is_command("M105 T0", "M105"));
  CHECK_FALSE(is_command("M1050", "M105"));
  CHECK_FALSE(is_command("M10", "M105"));
}

TEST_CASE("Commands that take minutes are waited for longer") {
  for (const std::string_view slow :
       {"G28", "G28 X", "G29", "G4 P100", "M109 S200", "M190 S60", "M400", "M600", "T1", "M0"}) {
    INFO(slow);
    CHECK(is_blocking(slow));
  }
  for (const std::string_view quick :
       {"G1 X1", "G0", "M104 S1", "M105", "G92 E0", "M106 S255", ""}) {
    INFO(quick);
    CHECK_FALSE(is_blocking(quick));
  }
}

}  // namespace
}  // namespace slipstick
