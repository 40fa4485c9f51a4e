#include "drivers/marlin/interjection.h"

#include <catch2/catch.hpp>
#include <limits>
#include <string>

using namespace slipstick;
using Catch::Contains;

namespace {

std::vector<std::string> texts(const Adjustment& adjustment) {
  const auto lines = lines_of(adjustment);
  std::vector<std::string> texts;
  if (!lines) return {lines.error().message};
  for (const Line& line : *lines) texts.push_back(line.text());
  return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("What neither moves nor waits may be said between two lines of a print") {
  for (const char* text : {"M104 S210", "M117 hello ; a comment", "M220 S90", "M290 Z0.02"}) {
    CHECK(interjection(text));
  }
  for (const char* text : {"G1 X1", "G28", "G92 E0", "M82", "M109 S200", "M112", "M110 N5", "T1",
                           "M84", "M600", "M114", "hello"}) {
    CAPTURE(text);
    const auto line = interjection(text);
    REQUIRE_FALSE(line);
    CHECK(line.error().code == ErrorCode::kInput);
  }
  CHECK_THAT(interjection("; nothing").error().message, Contains("no command"));
  CHECK(interjection("M117 " + std::string(90, 'x')));  // and loses its end
}

TEST_CASE("An adjustment is one line for each thing that is to be different") {
  CHECK(texts({.feed = 120, .flow = {}, .z = {}, .nozzle = {}, .bed = {}, .fan = {}}) ==
        Texts{"M220 S120"});
  CHECK(texts({.feed = 10, .flow = 200, .z = -0.05, .nozzle = 0, .bed = 60, .fan = 0.5}) ==
        Texts{"M220 S10", "M221 S200", "M290 Z-0.05", "M104 S0", "M140 S60", "M106 S128"});
}

TEST_CASE("An adjustment that is out of range changes nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double z : {-0.51, 0.51, nan}) {
    CHECK_THAT(texts({.feed = 100, .flow = {}, .z = z, .nozzle = {}, .bed = {}, .fan = {}}).at(0),
               Contains("z: ") && Contains("between -0.5 and 0.5"));
  }
  CHECK_THAT(texts({}).at(0), Contains("nothing"));
}
