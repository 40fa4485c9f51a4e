#include <fmt/format.h>

#include "core/base/check.h"
#include "core/contour/place_roots.h"
#include "core/contour/place_smooth.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/targets.h"
#include "tests/support/lower_bound.h"

namespace slipstick::targets {

using namespace bench;

namespace {

struct Edges {
  double paper = 0;   // midpoints, sliding, variational segmentation with alpha 10
  double fewest = 0;  // roots, fewest edges at a tenth of a cell
  double bound = 0;   // no polygon within the same windows has fewer
};

Edges edges_of(const Subject& s) {
  const auto section = s.solid->section(s.z);
  const auto image = sample(*section, s.grid);
  SLIPSTICK_CHECK(image.has_value());
  SimplifyOptions options;
  options.alpha = 10;
  options.tolerance = 1e9;  // the paper's test of distortion never binds
  ContourSet contours = trace(*image, Ambiguity::kSolid);
  place_sliding(contours);
  Edges edges;
  edges.paper = static_cast<double>(simplify_vsa(contours, options).outline.edges());
  place_roots(contours, *section);
  options.tolerance = 0.1 * s.grid.width();
  edges.fewest = static_cast<double>(simplify_fewest(contours, options).outline.edges());
  edges.bound = static_cast<double>(test::fewest_edges_bound(contours, options.tolerance));
  return edges;
}

}  // namespace

std::vector<Row> edge_rows() {
  double ratios = 0, worst = 0;
  std::string all, smooth;
  const auto subjects = edge_subjects();
  for (const Subject& s : subjects) {
    const Edges e = edges_of(s);
    ratios += e.fewest / e.paper;
    all += fmt::format(", {} {:.2f}", s.name, e.fewest / e.paper);
    if (!s.smooth) continue;
    worst = std::max(worst, e.fewest / e.bound);
    smooth += fmt::format(", {} {:.2f}", s.name, e.fewest / e.bound);
  }
  const double mean = ratios / static_cast<double>(subjects.size());
  return {{"edges, fewest at ±0.1 h against the paper's pipeline, mean over the models", "≤ 0.55 ×",
           fmt::format("{:.2f} × ({})", mean, all.substr(2)), mean <= 0.55},
          {"edges, fewest, against the proved lower bound on smooth shapes", "≤ 1.25 ×",
           fmt::format("{:.2f} × ({})", worst, smooth.substr(2)), worst <= 1.25}};
}

}  // namespace slipstick::targets
