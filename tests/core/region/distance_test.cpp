// Insets: the distance to the outline is exact, and its levels are loops that never cross and lie
// as deep as they say.
#include "core/region/distance.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/contour/audit.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/region/level.h"
#include "tests/support/images.h"
#include "tests/support/outlines.h"

using namespace slipstick;

namespace {

constexpr double kWidth = 0.125;
constexpr double kReach = 1;
constexpr double kTolerance = 0.0125;

BitImage drawn(Rng& rng) {
  return rng.below(4) == 0 ? test::noise(rng, 20, 20, 0.8) : test::structured(rng);
}

Outline outline_of(const BitImage& image) {
  return simplify_fewest(trace(image, Ambiguity::kSolid), {kTolerance, 10}).outline;
}

double from_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 edge = b - a;
  const double at = std::clamp(dot(p - a, edge) / dot(edge, edge), 0.0, 1.0);
  return length(p - a - at * edge);
}

// Every edge looked at.
double from_outline(Vec2 p, const std::vector<std::vector<Vec2>>& polygons) {
  double least = 1e9;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      least = std::min(least, from_segment(p, polygon[i], polygon[(i + 1) % polygon.size()]));
    }
  }
  return least;
}

template <typename Visit>
void for_each_inside(const BitImage& image, Visit visit) {
  for (int row = 0; row < image.rows(); ++row) {
    for (int column = 0; column < image.columns(); ++column) {
      if (image.at(column, row)) visit(column, row);
    }
  }
}

Vec2 node(const SliceGrid& grid, int column, int row) {
  return {grid.node_x(column), grid.node_y(row)};
}

}  // namespace

TEST_CASE("The distance of every inside node is that to the nearest edge, up to the reach") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    const BitImage image = drawn(rng);
    const Outline outline = outline_of(image);
    const auto polygons = polygons_of(outline);

    const DistanceField field(image, outline, kReach);

    double worst = 0;
    for_each_inside(image, [&](int column, int row) {
      const double real = from_outline(node(image.grid(), column, row), polygons);
      worst = std::max(worst, std::abs(field.at(column, row) - std::min(real, kReach)));
    });
    CHECK(worst < 1e-6);  // distances are kept in single precision
  }
}

TEST_CASE("Insets never cross and every vertex of one lies as deep as its level") {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    const BitImage image = drawn(rng);
    const Outline outline = outline_of(image);
    const auto polygons = polygons_of(outline);
    const DistanceField field(image, outline, kReach);
    const double level = 0.05 + 0.6 * rng.unit();
    const BitImage deep = field.at_least(level);

    const Outline inset = level_outline(deep, field, level, kTolerance, Ambiguity::kSolid);

    const auto loops = test::audit_loops_of(inset);
    CHECK(audit_loops(loops).empty());
    CHECK(audit_samples(loops, deep).empty());
    double worst = 0;
    for (const auto& loop : polygons_of(inset)) {
      for (const Vec2 p : loop) {
        worst = std::max(worst, std::abs(from_outline(p, polygons) - level));
      }
    }
    // Where the nearest edge changes within a stick the field is not linear.
    CHECK(worst <= kTolerance + kWidth / 4);
  }
}

TEST_CASE("What is within a level of a node that is as deep is inside") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    const BitImage image = drawn(rng);
    const double level = 0.05 + 0.6 * rng.unit();
    const BitImage deep = DistanceField(image, outline_of(image), kReach).at_least(level);
    const int reach = static_cast<int>(level / kWidth);

    std::size_t outside = 0;
    for_each_inside(deep, [&](int column, int row) {
      for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
          if (std::hypot(x, y) * kWidth < level && !image.at(column + x, row + y)) ++outside;
        }
      }
    });
    CHECK(outside == 0);
  }
}
