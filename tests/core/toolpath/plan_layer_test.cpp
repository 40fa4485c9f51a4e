// The law of toolpaths: what is laid has the components and holes of the contours, for any image.
#include "core/toolpath/plan_layer.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/region/level.h"
#include "core/toolpath/flow.h"
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

}  // namespace

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
