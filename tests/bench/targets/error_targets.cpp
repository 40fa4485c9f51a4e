#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/base/check.h"
#include "core/contour/place_roots.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

namespace {

constexpr int kPointsPerEdge = 8;

// f at p and its slope there by central differences, for the distance |f| / |grad f|.
double distance(Section& section, Vec2 p, double step) {
  const std::array<double, 5> xs{p.x, p.x - step, p.x + step, p.x, p.x};
  const std::array<double, 5> ys{p.y, p.y, p.y, p.y - step, p.y + step};
  std::array<double, 5> f{};
  SLIPSTICK_CHECK(section.evaluate(xs, ys, f));
  const double slope = std::hypot(f[2] - f[1], f[4] - f[3]) / (2 * step);
  return std::abs(f[0]) / slope;
}

// Root mean square, over the length of all edges, of the distance to f = 0, in cells.
double rms(const Outline& outline, Section& section, double width) {
  double sum = 0, length = 0;
  for (const Outline::Loop& loop : outline.loops()) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec2 a = outline.mm(loop.points[i]);
      const Vec2 b = outline.mm(loop.points[(i + 1) % loop.points.size()]);
      const double weight = std::hypot(b.x - a.x, b.y - a.y) / kPointsPerEdge;
      for (int k = 0; k < kPointsPerEdge; ++k) {
        const double d = distance(section, a + (k + 0.5) / kPointsPerEdge * (b - a), 1e-4 * width);
        sum += weight * d * d;
      }
      length += weight * kPointsPerEdge;
    }
  }
  return std::sqrt(sum / length) / width;
}

}  // namespace

std::vector<Row> error_rows() {
  double worst_fewest = 0, worst_roots = 0;
  std::string parts;
  for (const Subject& s : smooth_subjects()) {
    const auto section = s.solid->section(s.z);
    const auto image = sample(*section, s.grid);
    SLIPSTICK_CHECK(image.has_value());
    ContourSet contours = trace(*image, Ambiguity::kSolid);
    place_roots(contours, *section);
    SimplifyOptions options;
    options.tolerance = 0.1 * s.grid.width();
    const double fewest = rms(simplify_fewest(contours, options).outline, *section, s.grid.width());
    const double roots = rms(keep_all(contours).outline, *section, s.grid.width());
    worst_fewest = std::max(worst_fewest, fewest);
    worst_roots = std::max(worst_roots, roots);
    parts += fmt::format(", {} {:.3f} / {:.4f}", s.name, fewest, roots);
  }
  return {{"RMS error of contours on smooth shapes, fewest / roots alone", "≤ 0.05 h / ≤ 0.01 h",
           fmt::format("{:.3f} h / {:.4f} h ({})", worst_fewest, worst_roots, parts.substr(2)),
           worst_fewest <= 0.05 && worst_roots <= 0.01}};
}

}  // namespace slipstick::targets
