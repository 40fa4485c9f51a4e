// What slicers and people write into programs, and firmware cannot take as it is.
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "drivers/marlin/job_rules.h"
#include "drivers/marlin/line.h"

namespace slipstick {
namespace {

std::string sent(std::string_view raw) {
  const auto line = normalise(raw);
  if (!line) return "error: " + line.error().message;
  return *line ? (*line)->text() : "";
}

TEST_CASE("Messages lose the bytes that a printer cannot take, whatever alphabet they are in") {
  CHECK(sent("M117 Gr\xc3\xb6\xc3\x9f"
             "e 5\xc2\xb0") == "M117 Gr??e 5?");
  CHECK(sent("M117 Gr\xf6\xdf"
             "e") == "M117 Gr??e");
  CHECK(sent("M117 a*b \"c\" d\\e") == "M117 ab c de");
  CHECK(sent("M117 \x01\x7f\x08 x") == "M117 x");
  CHECK(sent("M0 Insert nut \xe2\x9c\x93") == "M0 Insert nut ?");
  CHECK(sent("M117 \xff") == "M117 ?");
  CHECK(sent("M117 see M110") == "M117 see M 110");
  CHECK(sent("M117 M1M110") == "M117 M1M 110");
}

TEST_CASE("A long name of an object loses its end, as a message does") {
  const std::string name = "M486 A" + std::string(300, 'n');
  CHECK(sent(name) == name.substr(0, Line::kMaxText));
}

TEST_CASE("Byte order marks, comments in any alphabet and line ends of any kind are no commands") {
  CHECK(sent("\xef\xbb\xbf; made by hand") == "");
  CHECK(sent("\xef\xbb\xbfG28") == "G28");
  CHECK(sent("G1 X1 ; \xc3\xa4\xff\x01 * \\ \"") == "G1 X1");
  CHECK(sent("G1 X1\r") == "G1 X1");
  CHECK(sent(std::string_view("G1 X1 ;\0", 8)) == "G1 X1");
}

TEST_CASE("Bytes that cannot be sent in a command are refused, not dropped") {
  for (const std::string_view bad :
       {std::string_view("G1 X\xc3\xb6"), std::string_view("G1\0X1", 5),
        std::string_view("M23x\\y"), std::string_view("M98 P\"a\"")}) {
    CHECK(sent(bad).starts_with("error: "));
  }
}

TEST_CASE("What may be sent is left as it is when it is read again, whatever bytes it came from") {
  Rng rng(11);
  const std::string_view words = "G1 X1.25 M117 M110 M486 A @pause ;(N5 *71 \"\\ \xc3\xb6\r\t ";
  int kept = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string raw;
    for (std::uint64_t piece = rng.below(5) + 1; piece > 0; --piece) {
      raw += words.substr(rng.below(words.size()), rng.below(12));
      if (rng.below(4) == 0) raw += static_cast<char>(rng.below(256));
    }
    const auto once = normalise(raw);
    if (!once || !*once) continue;
    ++kept;
    INFO(raw);
    REQUIRE(sent((*once)->text()) == (*once)->text());
  }
  CHECK(kept > 1000);
}

TEST_CASE("What has no place in a job is refused with the reason") {
  for (const std::string_view card :
       {"M23 a.gco", "M24", "M26 S0", "M28 b.gco", "M29", "M30 c.gco", "M32 d.gco", "M928 log"}) {
    CHECK_THAT(sent(card), Catch::Contains("the printer's own card"));
  }
  for (const std::string_view end : {"M112", "M410", "M997", "N5 M112*1"}) {
    CHECK_THAT(sent(end), Catch::Contains("it stops the printer"));
  }
  for (const std::string_view word : {"@pause", "@cancel now", "@abort", "M25"}) {
    CHECK_THAT(sent(word), Catch::Contains("M0 or M600"));
  }
}

TEST_CASE("Pauses of the printer itself are sent; words to other hosts are comments") {
  CHECK(sent("M0") == "M0");
  CHECK(sent("M1 S5") == "M1 S5");
  CHECK(sent("M600") == "M600");
  CHECK(sent("M226 P1") == "M226 P1");
  CHECK(sent("@OBJECT cube") == "");
  CHECK(sent(";@pause") == "");
}

}  // namespace
}  // namespace slipstick
