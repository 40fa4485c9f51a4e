// Defects that show only against the layers next to them: infill that is missing, layers left out.
#include "sim/layer_series.h"

#include "sim/coverage.h"
#include "tests/sim/planted.h"

using namespace slipstick;

namespace {

const Contours kBlock{square({0, 0}, 20)};

/// Two rings of perimeter and lines `spacing` apart across and along, `layers` high.
Beads sparse_block(int layers, double spacing) {
  Beads beads;
  for (int layer = 0; layer < layers; ++layer) {
    for (const double inset : {0.2, 0.6}) {
      const std::vector<Vec2> ring = square({inset, inset}, 20 - 2 * inset);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        bead(beads, ring[i], ring[(i + 1) % ring.size()], layer);
      }
    }
    for (double at = 1 + spacing; at < 19; at += spacing) {
      bead(beads, {at, 0.6}, {at, 19.4}, layer);
      bead(beads, {0.6, at}, {19.4, at}, layer);
    }
  }
  return beads;
}

PrintVerdict judge_block(const Beads& beads) {
  return judged(beads, std::vector<Contours>(8, kBlock));
}

}  // namespace

TEST_CASE("Infill that is missing in a layer, or in a part of it, is found in the hollow") {
  Beads beads = sparse_block(8, 3);
  REQUIRE(judge_block(beads).wrong() == 0);
  std::erase_if(beads, [](const ExtrudedSegment& b) {  // Layer 4, what crosses the left half.
    const bool inside = b.a.x > 0.65 && b.a.x < 10 && b.b.x < 10;
    const bool across = b.a.x < 0.65 && b.b.x > 19 && b.a.y > 0.65 && b.a.y < 19.35;
    return std::abs(b.z - 5 * kHeight) < 0.01 && (inside || across);
  });

  const PrintVerdict v = judge_block(beads);

  REQUIRE(v.defects.size() == 1);
  CHECK(v.infill_missing == 1);
  check_at(v.defects[0], DefectKind::kInfillMissing, 4, {5.5, 10}, 5);
  CHECK(v.wrong() == 1);
}

TEST_CASE("A part that is hollow, has skins or wider infill is as it was meant") {
  CHECK(judge_block(sparse_block(8, 100)).wrong() == 0);
  CHECK(judge_block(sparse_block(8, 6)).wrong() == 0);
  Beads skinned = sparse_block(8, 3);
  for (const int layer : {0, 1, 6, 7}) fill(skinned, {0, 0}, 20, layer);
  CHECK(judge_block(skinned).wrong() == 0);
}

TEST_CASE("A layer that was left out is found below the one that took its place") {
  Beads beads;
  for (int layer = 0; layer < 8; ++layer) {
    if (layer == 4) continue;
    const double height = layer == 5 ? 2 * kHeight : kHeight;
    fill(beads, {0, 0}, 20, layer);
    for (ExtrudedSegment& b : beads) {
      if (std::abs(b.z - (layer + 1) * kHeight) < 0.01) b.height = height;
    }
  }

  const PrintVerdict v = judge_block(beads);

  REQUIRE(v.layers_missing == 1);
  REQUIRE(v.defects.size() == 1);
  // In the middle of the first of its longest rows.
  check_at(v.defects[0], DefectKind::kLayerMissing, 4, {10, 0}, 0.1);
  CHECK(v.defects[0].z == Approx(5 * kHeight));
  CHECK(v.defects[0].defect.mm2 == Approx(400).epsilon(0.01));
}

TEST_CASE("A thick first layer, or layers that grow, leave none out") {
  const auto heights = [](std::initializer_list<double> all) {
    std::vector<LayerTrace> traces;
    double top = 0;
    for (const double height : all) traces.push_back({top += height, height, 0, {}});
    return gaps_in(traces);
  };

  CHECK(heights({0.3, 0.1, 0.1}).empty());
  CHECK(heights({0.1, 0.2, 0.2, 0.2}).empty());
  CHECK(heights({0.1, 0.15, 0.2, 0.3}).empty());
  CHECK(heights({0.2}).empty());
  const auto gap = heights({0.3, 0.2, 0.6, 0.2});
  REQUIRE(gap.size() == 1);
  CHECK((gap[0].above == 2 && gap[0].missing == 2 && gap[0].height == Approx(0.2)));
  CHECK(heights({0.3, 0.4, 0.2}).size() == 1);
  CHECK(heights({0.2, 0.4}).size() == 1);
}

TEST_CASE("The largest square is found, and its middle") {
  PixelImage image(PixelFrame::over({{0, 0}, {2, 2}}, 0.1));
  CHECK(largest_square(image).side == 0);
  for (int row = 3; row < 9; ++row) image.set(row, 2, row < 8 ? 9 : 4);

  const LargestSquare square = largest_square(image);

  CHECK(square.side == 5);
  CHECK(square.middle.y == Approx(image.frame().centre(0, 5).y));
}
