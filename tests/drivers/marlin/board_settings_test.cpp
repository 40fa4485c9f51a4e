#include "drivers/marlin/board_settings.h"

#include <catch2/catch.hpp>
#include <string>

namespace slipstick {
namespace {

std::vector<std::string> kept(const std::vector<std::string>& lines) {
  BoardSettings settings;
  for (const std::string& line : lines) settings.follow(*Line::make(line));
  std::vector<std::string> texts;
  for (const Line& line : settings.lines()) texts.push_back(line.text());
  return texts;
}

TEST_CASE("What sets a board up is kept in the order in which it was last said") {
  CHECK(kept({"M204 P1000", "G1 X1", "M900 K0.05", "M104 S200", "M204 T2000", "M204 P1000"}) ==
        std::vector<std::string>{"M900 K0.05", "M204 T2000", "M204 P1000"});
}

TEST_CASE("Settings that change with every line do not grow without end") {
  std::vector<std::string> lines{"M900 K1"};
  for (std::size_t i = 0; i < BoardSettings::kMax; ++i)
    lines.push_back("M204 P" + std::to_string(i));

  const auto last = kept(lines);

  CHECK(last.size() == BoardSettings::kMax);
  CHECK(last.front() == "M204 P0");
}

}  // namespace
}  // namespace slipstick
