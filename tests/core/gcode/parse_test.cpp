#include "core/gcode/parse.h"

#include <catch2/catch.hpp>
#include <string>

#include "core/base/rng.h"

using namespace slipstick;

TEST_CASE("A command is its letter, number and words") {
  const auto command = parse_gcode("G1 X10 Y-2.5 E.05 F1800");

  REQUIRE(command);
  CHECK(command->is('G', 1));
  CHECK(command->value('X') == 10.0);
  CHECK(command->value('Y') == -2.5);
  CHECK(command->value('E') == 0.05);
  CHECK(command->value('F') == 1800.0);
  CHECK_FALSE(command->has('Z'));
}

TEST_CASE("Words may touch each other and an E is never an exponent") {
  const auto command = parse_gcode("G01X1E3Y+2");

  REQUIRE(command);
  CHECK(command->is('G', 1));
  CHECK(command->value('X') == 1.0);
  CHECK(command->value('E') == 3.0);
  CHECK(command->value('Y') == 2.0);
}

TEST_CASE("A word without a number is there but has no value") {
  const auto command = parse_gcode("G28 X Y");

  REQUIRE(command);
  CHECK(command->has('X'));
  CHECK_FALSE(command->value('X'));
  CHECK(command->has('Y'));
}

TEST_CASE("Names of infinities are words, not numbers") {
  const auto command = parse_gcode("M104 Sinf");

  REQUIRE(command);
  CHECK_FALSE(command->value('S'));
}

TEST_CASE("Line number, checksum and comment are no part of the command") {
  CHECK(bare_command("  N12 M105*20 ;foo") == "M105");
  CHECK(bare_command("N-1 M110*15") == "M110");
  CHECK(bare_command("X5 M105*36") == "X5 M105");
  CHECK(bare_command("G1 X1  *5") == "G1 X1");
}

TEST_CASE("A message keeps its text") {
  const auto command = parse_gcode("N3 M117 Layer 1 of 20*9");

  REQUIRE(command);
  CHECK(command->text() == "Layer 1 of 20");
}

TEST_CASE("What is no command gives nothing") {
  for (const char* line : {"", "   ", "; only a comment", "FOO", "g1 X1", "G", "M-1", "*5", "N5"}) {
    CHECK_FALSE(parse_gcode(line));
  }
}

TEST_CASE("Any bytes can be parsed") {
  Rng rng(1);
  for (int round = 0; round < 20'000; ++round) {
    std::string line;
    for (std::uint64_t i = rng.below(40); i > 0; --i) {
      line += rng.below(4) != 0 ? "GMTXYZEFNS0123456789.-+ *;"[rng.below(26)]
                                : static_cast<char>(rng.below(256));
    }
    const auto command = parse_gcode(line);
    if (command) CHECK(command->code() >= 0);
  }
}
