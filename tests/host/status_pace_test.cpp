#include "host/status_pace.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <iterator>
#include <string>
#include <vector>

#include "core/base/rng.h"

using namespace slipstick;

namespace {

using Program = std::vector<std::string>;

Program thinned(const Program& program) {
  StatusPace pace;
  Program sent;
  const auto take = [&] {
    while (const auto line = pace.pop()) sent.push_back(line->text());
  };
  for (const std::string& text : program) {
    pace.push(*Line::make(text));
    take();
  }
  pace.end();
  take();
  return sent;
}

bool is_status(const std::string& text) {
  return is_command(text, "M73") || is_command(text, "M117");
}

/// Moves of an eighth of a second there and back, with what `between` makes of their number before
/// each.
template <typename Between>
Program moves(int count, Between between) {
  Program program{"G92 X0 Y0 Z0", "G1 X0 Y0 Z0 F480"};
  for (int i = 0; i < count; ++i) {
    program.push_back(between(i));
    program.push_back(i % 2 == 0 ? "G1 X1" : "G1 X0");
  }
  return program;
}

}  // namespace

TEST_CASE("Of progress written before every move one line a second is sent, the latest") {
  const auto sent = thinned(moves(28, [](int i) { return "M73 P" + std::to_string(i); }));

  Program progress;
  std::ranges::copy_if(sent, std::back_inserter(progress), is_status);
  CHECK(progress == Program{"M73 P0", "M73 P8", "M73 P16", "M73 P24", "M73 P27"});
}

TEST_CASE("Messages as rare as those of slicers are sent where they stand") {
  const Program program{"M73 P0 R60",   "M117 Heating", "M109 S200",  "M117 Layer 1",
                        "M73 P1 R60",   "G28",          "G1 X0 F600", "G1 X20",
                        "M117 Layer 2", "G1 X0",        "M73 P2 R59", "M104 S0"};

  CHECK(thinned(program) == program);
}

TEST_CASE("The latest message stands before a command that the printer waits at, and at the end") {
  const Program program{"G92 X0 Y0 Z0", "G1 X0 F600", "M117 a", "G1 X1", "M117 b",
                        "M117 c",       "M0",         "M117 d", "G1 X0", "M117 e"};

  CHECK(thinned(program) == Program{"G92 X0 Y0 Z0", "G1 X0 F600", "M117 a", "G1 X1", "M117 c", "M0",
                                    "M117 d", "G1 X0", "M117 e"});
}

TEST_CASE("Nothing else is thinned out, and no two messages of a kind come within a second") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    INFO(seed);
    Rng rng(seed);
    const Program program = moves(100, [&](int i) -> std::string {
      constexpr std::array kLines{"M117 a", "M73 P1", "M106 S9", "M204 S500", "M118 x"};
      return kLines[rng.below(kLines.size())] + std::to_string(i);
    });

    const Program sent = thinned(program);

    Program before = program;
    Program after = sent;
    std::erase_if(before, is_status);
    std::erase_if(after, is_status);
    CHECK(after == before);
    for (const char* kind : {"M73", "M117"}) {
      int moved = 8;
      for (std::size_t i = 0; i < sent.size(); ++i) {
        if (is_command(sent[i], "G1")) ++moved;
        if (!is_command(sent[i], kind)) continue;
        const bool last = std::none_of(sent.begin() + std::ptrdiff_t(i) + 1, sent.end(),
                                       [](const auto& text) { return !is_status(text); });
        CHECK((last || moved >= 8));
        moved = 0;
      }
    }
  }
}
