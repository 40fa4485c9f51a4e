// The law of toolpaths: what is laid has the components and holes of the contours, for any image.
#include "core/toolpath/plan_layer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/region/level.h"
#include "core/toolpath/flow.h"
#include "core/toolpath/walls.h"
#include "sim/judge.h"
#include "tests/support/images.h"

using namespace slipstick;

namespace {

constexpr double kHeight = 0.2;

std::vector<ExtrudedSegment> segments_of(const LayerToolpaths& layer) {
  std::vector<ExtrudedSegment> segments;
  for (const Bead& bead : layer.beads) {
    const std::size_t count = bead.closed ? bead.points.size() : bead.points.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      const double width = bead.widths.size() == 1 ? bead.widths[0] : bead.widths[i];
      segments.push_back({bead.points[i], bead.points[i + 1 < bead.points.size() ? i + 1 : 0],
                          width, kHeight, layer.top});
    }
  }
  return segments;
}

double volume_of(const LayerToolpaths& layer) {
  double volume = 0;
  for (const ExtrudedSegment& s : segments_of(layer)) {
    volume += bead_area(s.width, kHeight) * length(s.b - s.a);
  }
  return volume;
}

// `image` without one node in four.
BitImage with_gaps(const BitImage& image, Rng& rng) {
  BitImage result = image;
  for (int row = 1; row + 1 < image.rows(); ++row) {
    for (int column = 1; column + 1 < image.columns(); ++column) {
      if (rng.below(4) == 0) result.set(column, row, false);
    }
  }
  return result;
}

double from_bead(Vec2 p, const Bead& bead) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
    const Vec2 a = bead.points[i], edge = bead.points[i + 1] - a;
    const double at = std::clamp(dot(p - a, edge) / dot(edge, edge), 0.0, 1.0);
    least = std::min(least, length(p - a - at * edge));
  }
  return least;
}

double from_skin(Vec2 p, const LayerToolpaths& layer) {
  double least = 1e9;
  for (const Bead& bead : layer.beads) {
    if (bead.role == Role::kSkin) least = std::min(least, from_bead(p, bead));
  }
  return least;
}

}  // namespace

TEST_CASE("What is bare above or below, inside the perimeters, lies under skin") {
  std::size_t bare = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    const BitImage image = test::structured(rng);
    BitImage above = image, below = image;
    (rng.below(2) == 0 ? above : below) = with_gaps(image, rng);
    PrintSettings settings;
    settings.toolpath.perimeters = 1;
    settings.toolpath.infill_density = 0;
    settings.toolpath.line_width = 0.2;
    const Outline outline = simplify_greedy(trace(image, Ambiguity::kSolid), {}).outline;
    INFO("seed " << seed);

    const LayerToolpaths layer =
        plan_layer({1, 0.4, kHeight, image, outline, above, below}, settings);

    const LineMeasures lines = measures_of(settings, 1, kHeight);
    // A node lies between two lines, or less than a line from the end of one.
    const DistanceField depth(image, outline, lines.infill_edge() + lines.spacing);
    for (int row = 0; row < image.rows(); ++row) {
      for (int column = 0; column < image.columns(); ++column) {
        if (depth.at(column, row) < lines.infill_edge() + lines.spacing / 2) continue;
        if (above.at(column, row) && below.at(column, row)) continue;
        ++bare;
        const Vec2 p{image.grid().node_x(column), image.grid().node_y(row)};
        CHECK(from_skin(p, layer) <= lines.spacing);
      }
    }
  }
  CHECK(bare > 50);
}

TEST_CASE("An island that a ring of no length would fit into is laid as a dot") {
  BitImage image(test::small_grid(3, 3));
  image.set(3, 3, true);
  const Outline outline = keep_all(trace(image, Ambiguity::kSolid)).outline;
  const double depth = 0.0625 * std::numbers::sqrt2 / 2;  // of the one node in a square on edge
  PrintSettings settings;
  settings.toolpath.line_width = 2 * (depth - 0.0005) - settings.slicing.tolerance;

  const LayerToolpaths layer =
      plan_layer({1, 0.4, kHeight, image, outline, image, image}, settings);

  const double width = settings.toolpath.line_width;
  REQUIRE(!layer.beads.empty());
  CHECK(layer.beads[0].role == Role::kOuterPerimeter);
  CHECK(volume_of(layer) == Approx(bead_area(width, kHeight) * width / 2));
}

TEST_CASE("Any layer is laid with the components and holes of its contours") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    const BitImage image = seed % 4 == 0 ? test::noise(rng, 24, 24, 0.7) : test::structured(rng);
    PrintSettings settings;
    settings.toolpath.perimeters = 1 + static_cast<int>(rng.below(3));
    settings.toolpath.infill_density = 0.5 * static_cast<double>(rng.below(3));
    const Outline outline = simplify_greedy(trace(image, Ambiguity::kSolid), {}).outline;
    const BitImage above = rng.below(2) == 0 ? image : BitImage(image.grid());
    INFO("seed " << seed);

    const LayerToolpaths layer =
        plan_layer({1, 0.4, kHeight, image, outline, above, image}, settings);

    const LayerVerdict verdict =
        judge_layer(segments_of(layer), polygons_of(outline), {.pixel = 0.125 / 4});
    CHECK(verdict.components_wrong == 0);
    CHECK(verdict.holes_wrong == 0);
  }
}
