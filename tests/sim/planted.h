#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sim/print_judge.h"

namespace slipstick {

/// \file
/// Layers of beads laid by hand, in which tests plant defects, and what the judge says of them.

inline constexpr double kWidth = 0.45;
inline constexpr double kHeight = 0.2;

using Beads = std::vector<ExtrudedSegment>;

inline std::vector<Vec2> square(Vec2 low, double side) {
  return {low, {low.x + side, low.y}, {low.x + side, low.y + side}, {low.x, low.y + side}};
}

inline std::vector<Vec2> reversed(std::vector<Vec2> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// A square filled with beads side by side, 0.4 mm apart.
inline void fill(Beads& beads, Vec2 low, double side, int layer) {
  const double z = (layer + 1) * kHeight;
  const double near = kWidth / 2;
  for (double y = near; y < side - near + 0.2; y += 0.4) {
    const double row = low.y + std::min(y, side - near);
    beads.push_back({{low.x + near, row}, {low.x + side - near, row}, kWidth, kHeight, z});
  }
  for (const double x : {low.x + near, low.x + side - near}) {
    beads.push_back({{x, low.y + near}, {x, low.y + side - near}, kWidth, kHeight, z});
  }
}

inline void bead(Beads& beads, Vec2 a, Vec2 b, int layer) {
  beads.push_back({a, b, kWidth, kHeight, (layer + 1) * kHeight});
}

inline PrintVerdict judged(Beads beads, const std::vector<Contours>& contours) {
  std::stable_sort(beads.begin(), beads.end(), [](auto& a, auto& b) { return a.z < b.z; });
  PrintJudge judge([&](double z, double) {
    return contours[static_cast<std::size_t>(std::lround(z / kHeight)) - 1];
  });
  for (const ExtrudedSegment& b : beads) judge.add(b);
  return judge.finish();
}

inline void check_at(const PrintDefect& d, DefectKind kind, int layer, Vec2 place, double within) {
  INFO(describe(d.defect.kind) << " at " << d.defect.place.x << ", " << d.defect.place.y);
  CHECK(d.defect.kind == kind);
  CHECK(d.layer == layer);
  CHECK(length(d.defect.place - place) < within);
}

}  // namespace slipstick
