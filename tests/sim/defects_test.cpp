// Planted defects: what the judge says is wrong, and where.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "sim/coverage.h"
#include "sim/print_judge.h"
#include "sim/shortest_way.h"
#include "tests/sim/planted.h"

using namespace slipstick;

namespace {

/// Two blocks side by side, 2 mm apart, three layers high.
const Contours kTwoBlocks{square({0, 0}, 5), square({7, 0}, 5)};

Beads two_blocks() {
  Beads beads;
  for (int layer = 0; layer < 3; ++layer) {
    fill(beads, {0, 0}, 5, layer);
    fill(beads, {7, 0}, 5, layer);
  }
  return beads;
}

PrintVerdict judge_blocks(const Beads& beads) {
  return judged(beads, {kTwoBlocks, kTwoBlocks, kTwoBlocks});
}

}  // namespace

TEST_CASE("Of a print as it should be nothing is said") {
  const PrintVerdict v = judge_blocks(two_blocks());

  CHECK(v.layers == 3);
  CHECK(v.wrong() == 0);
  CHECK(v.defects.empty());
}

TEST_CASE("Islands that a thread joins are found at the thread") {
  Beads beads = two_blocks();
  for (int layer = 0; layer < 3; ++layer) bead(beads, {4.8, 1.5}, {7.2, 3.5}, layer);

  const PrintVerdict v = judge_blocks(beads);

  REQUIRE(v.defects.size() == 3);
  for (int i = 0; i < 3; ++i) {
    check_at(v.defects[static_cast<std::size_t>(i)], DefectKind::kIslandsJoined, i, {6, 2.5}, 0.4);
  }
}

TEST_CASE("A bridge over nothing is in the air, wherever it hangs") {
  Beads beads = two_blocks();
  SECTION("between two islands: they are joined as well") {
    bead(beads, {4.8, 2}, {7.2, 2}, 1);

    const PrintVerdict v = judge_blocks(beads);

    REQUIRE(v.defects.size() == 2);
    check_at(v.defects[0], DefectKind::kInTheAir, 1, {6, 2}, 0.3);
    check_at(v.defects[1], DefectKind::kIslandsJoined, 1, {6, 2}, 0.3);
  }
  SECTION("far from the part, where it is stray") {
    bead(beads, {20, 2}, {24, 2}, 1);

    const PrintVerdict v = judge_blocks(beads);

    REQUIRE(v.defects.size() == 1);
    check_at(v.defects[0], DefectKind::kInTheAir, 1, {22, 2}, 0.3);
  }
  SECTION("but not on the bed") {
    bead(beads, {20, 2}, {24, 2}, 0);

    CHECK(judge_blocks(beads).defects.empty());
  }
}

TEST_CASE("A bridge that the solid asks for is counted, not wrong, as long as something holds it") {
  const Contours slab{{{0, 0}, {12, 0}, {12, 5}, {0, 5}}};
  Beads beads = two_blocks();
  std::erase_if(beads, [](const ExtrudedSegment& b) { return b.z > 0.5; });
  for (double y = 0.225; y < 4.9; y += 0.35) bead(beads, {0.225, y}, {11.775, y}, 2);

  const PrintVerdict v = judged(beads, {kTwoBlocks, kTwoBlocks, slab});

  CHECK(v.defects.empty());
  CHECK(v.overhang_mm2 == Approx((2 - 2 * 0.45) * 5).epsilon(0.1));
}

TEST_CASE("An island that hangs on nothing is in the air though the solid asks for it") {
  Beads beads = two_blocks();
  std::erase_if(beads, [](const ExtrudedSegment& b) { return b.z < 0.3 && b.a.x > 6; });

  const PrintVerdict v = judged(beads, {{kTwoBlocks[0]}, kTwoBlocks, kTwoBlocks});

  REQUIRE(v.defects.size() == 1);
  check_at(v.defects[0], DefectKind::kInTheAir, 1, {9.5, 2.5}, 2.6);
  CHECK(v.defects[0].defect.mm2 == Approx(25).epsilon(0.03));
}

TEST_CASE("A membrane that closes a gap is found in the gap") {
  const Contours frame{square({0, 0}, 10), reversed(square({4, 4}, 2))};
  Beads beads;
  fill(beads, {0, 0}, 10, 0);

  const PrintVerdict v = judged(beads, {frame});

  REQUIRE(v.defects.size() == 1);
  check_at(v.defects[0], DefectKind::kHoleClosed, 0, {5, 5}, 1.1);
}

TEST_CASE("A hole that opens to the outside is found at the breach") {
  const Contours frame{square({0, 0}, 10), reversed(square({1, 1}, 8))};
  Beads beads;
  for (const double at : {0.3, 0.7}) {
    const auto loop = square({at, at}, 10 - 2 * at);
    bead(beads, loop[0], loop[1], 0);
    bead(beads, loop[2], loop[3], 0);
    bead(beads, loop[3], loop[0], 0);
    bead(beads, loop[1], {loop[1].x, 4}, 0);
    bead(beads, {loop[1].x, 5}, loop[2], 0);
  }

  const PrintVerdict v = judged(beads, {frame});

  CHECK(v.holes_wrong == 1);
  const auto found = std::find_if(v.defects.begin(), v.defects.end(), [](const PrintDefect& d) {
    return d.defect.kind == DefectKind::kHolesJoined;
  });
  REQUIRE(found != v.defects.end());
  CHECK(length(found->defect.place - Vec2{9.5, 4.5}) < 0.6);
}

TEST_CASE("A perimeter that was not laid leaves a bare rim as long as it") {
  Beads beads = two_blocks();
  std::erase_if(beads, [](const ExtrudedSegment& b) {  // the front row of the left block
    return b.z > 0.3 && b.z < 0.5 && b.a.x < 6 && b.a.y < 0.3 && b.b.y < 0.3;
  });

  const PrintVerdict v = judge_blocks(beads);

  REQUIRE(v.defects.size() == 1);
  check_at(v.defects[0], DefectKind::kRimBare, 1, {2.5, 0.2}, 0.3);
  CHECK(v.defects[0].defect.mm2 == Approx(0.4 * 4.1).epsilon(0.1));
  CHECK(v.components_wrong == 0);
}

TEST_CASE("A prime line at a height of its own is no layer") {
  Beads beads;
  beads.push_back({{-20, -20}, {40, -20}, 0.5, 0.3, 0.3});
  const Beads part = two_blocks();
  beads.insert(beads.end(), part.begin(), part.end());
  PrintJudge judge([](double, double) { return kTwoBlocks; });
  for (const ExtrudedSegment& b : beads) judge.add(b);

  const PrintVerdict v = judge.finish();

  CHECK(v.layers == 3);
  CHECK(v.layers_unknown == 1);
  CHECK(v.defects.empty());
}

TEST_CASE("A window is a tunnel, with a floor a pit, with a floor and a lid a cavity") {
  const Box2 area{{0, 0}, {1, 1}};
  const PixelFrame frame = PixelFrame::over(area, 0.05);
  PixelImage plate(frame);
  for (int r = 2; r < 18; ++r) plate.set(r, 2, 18);
  PixelImage window = plate;
  for (int r = 8; r < 12; ++r) window.clear(r, 8, 12);
  const auto topology = [&](const std::vector<PixelImage>& layers) {
    auto ledger = PrintLedger::over(area, 0.05);
    REQUIRE(ledger);
    for (const PixelImage& layer : layers) ledger->add(layer);
    return ledger->topology();
  };

  CHECK(topology({window, window}) == Topology{1, 1, 0});
  CHECK(topology({plate, window, window}) == Topology{1, 0, 0});
  CHECK(topology({plate, window, plate}) == Topology{1, 0, 1});
}

TEST_CASE("A shortest way has its middle on the ground, as far from one end as from the other") {
  Rng rng(5);
  const PixelFrame frame = PixelFrame::over({{0, 0}, {2, 2}}, 0.1);
  int found = 0;
  for (int round = 0; round < 200; ++round) {
    PixelImage ground(frame);
    for (int r = 1; r < frame.rows - 1; ++r) {
      for (int c = 1; c < frame.columns - 1; ++c) {
        if (rng.below(10) < 7) ground.set(r, c, c + 1);
      }
    }
    const PixelRun from{1, 1, 3, 0, 0};
    const PixelRun to{frame.rows - 2, 3, 9, 0, 0};
    const auto middle =
        middle_of_shortest_way(ground, std::vector{from}, std::vector{to}, Steps::kSides);

    // The oracle floods from both ends with one ring a time.
    const auto distances = [&](const PixelRun& run) {
      std::vector<int> d(static_cast<std::size_t>(frame.columns * frame.rows), -1);
      const auto at = [&](int r, int c) -> int& {
        return d[static_cast<std::size_t>(r * frame.columns + c)];
      };
      for (int c = run.begin; c < run.end; ++c) {
        if (ground.at(run.row, c)) at(run.row, c) = 0;
      }
      for (int ring = 0; ring < frame.columns * frame.rows; ++ring) {
        for (int r = 1; r < frame.rows - 1; ++r) {
          for (int c = 1; c < frame.columns - 1; ++c) {
            const bool near = at(r, c - 1) == ring || at(r, c + 1) == ring ||
                              at(r - 1, c) == ring || at(r + 1, c) == ring;
            if (near && at(r, c) < 0 && ground.at(r, c)) at(r, c) = ring + 1;
          }
        }
        if (std::find(d.begin(), d.end(), ring + 1) == d.end()) break;
      }
      return d;
    };
    const auto a = distances(from);
    const auto b = distances(to);
    int shortest = -1;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] >= 0 && b[i] == 0 && (shortest < 0 || a[i] < shortest)) shortest = a[i];
    }
    REQUIRE(middle.has_value() == (shortest >= 0));
    if (!middle) continue;
    ++found;
    const auto i = static_cast<std::size_t>(frame.row_from(middle->y - 0.01) * frame.columns +
                                            frame.column_from(middle->x - 0.01));
    CHECK(a[i] + b[i] == shortest);
    CHECK(std::abs(a[i] - b[i]) <= 1);
  }
  CHECK(found > 50);
}

TEST_CASE("An image within another window of the raster keeps its pixels where they are") {
  const PixelFrame frame = PixelFrame::over({{0, 0}, {7, 3}}, 0.05);
  PixelImage image(frame);
  image.draw_capsule({1, 1}, {6, 2}, 0.8);
  const PixelFrame larger = PixelFrame::over({{-3.33, -1.21}, {9, 4}}, 0.05);

  const PixelImage there = image.within(larger);

  CHECK(there.count() == image.count());
  PixelImage drawn(larger);
  drawn.draw_capsule({1, 1}, {6, 2}, 0.8);
  CHECK(drawn.count_without(there) == 0);
  CHECK(there.within(frame).count_without(image) == 0);
  CHECK(image.within(PixelFrame::over({{2, 0}, {3, 3}}, 0.05)).count() < image.count());
}

TEST_CASE("Shrinking undoes growing of what is as thick as a pixel and its neighbours") {
  const PixelFrame frame = PixelFrame::over({{0, 0}, {7, 3}}, 0.05);
  PixelImage image(frame);
  image.set(20, 30, 95);

  CHECK(image.grown().shrunk().count() == image.count());
  CHECK(image.shrunk().count() == 0);
  CHECK(image.grown().grown().shrunk().count() == image.grown().count());
}
