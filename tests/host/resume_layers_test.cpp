// A print that is sliced as it goes is cut off, and taken up in the middle of a layer that is made
// again.
#include <catch2/catch.hpp>
#include <fstream>

#include "tests/host/layer_bench.h"

using namespace slipstick;
using Catch::Contains;
using test::LayerBench;

namespace {

constexpr int kNever = LayerBench::kNever;

// The speed of a bead depends on what else was queued when it came.
std::vector<test::Bead> without_speed(std::vector<test::Bead> beads) {
  for (test::Bead& bead : beads) bead.back() = 0;
  return beads;
}

}  // namespace

TEST_CASE("A layer that was cut off is made again, and the print goes on in the middle of it") {
  LayerBench whole;
  REQUIRE(whole.start(kNever));
  const auto expected = without_speed(whole.beads());
  REQUIRE(whole.layers_sliced() == 12);
  REQUIRE(expected.size() > 300);

  int taken_up = 0;
  for (int cut = 20;; cut += 83) {
    INFO("cut off at write " << cut);
    LayerBench bench;
    if (bench.start(cut)) break;
    const auto outcome = bench.resume();
    INFO((outcome ? "" : outcome.error().message));
    REQUIRE(outcome);
    REQUIRE(without_speed(bench.beads()) == expected);
    CHECK(bench.layers_sliced() <= 12 + 2);
    ++taken_up;
  }
  CHECK(taken_up > 4);
}

TEST_CASE("A layer that is not what it was is not gone on with") {
  LayerBench bench;
  REQUIRE(!bench.start(400));
  auto content = *read_journal(bench.journal());
  std::string other =
      header_record(content.header) + session_record(content.session->first, content.session->base);
  for (const OtherLine& line : content.session->others) {
    other += other_record(line.number, line.text);
  }
  for (LayerMark mark : content.layers) {
    ++mark.program;
    other += layer_record(mark);
  }
  std::ofstream(bench.journal()) << other << taken_record(content.taken);

  const auto outcome = bench.resume();

  REQUIRE(!outcome);
  CHECK_THAT(outcome.error().message, Contains("would not be what it was"));
}
