#include <algorithm>

#include "core/contour/cluster.h"
#include "core/contour/outline_builder.h"
#include "core/contour/proxy.h"
#include "core/contour/simplify.h"
#include "core/contour/vsa_regions.h"

namespace slipstick {
namespace {

// Verification and splitting of the regions of one loop (section 5.2), in units of 1/65536 of a
// cell.
//
// The paper's distortion test compares D', a length cubed, with the square of r', and by its own
// tables never binds. Ours bounds the deviation, a length; D' is reported.
class Verifier {
 public:
  Verifier(const LoopView& loop, double tolerance) : loop_(loop), tolerance_(tolerance) {}

  // Appends the first vertices of the edges that replace `run`. Each cut makes runs shorter and a
  // run of one edge always passes, so the recursion is no deeper than the run is long; in practice
  // log of that.
  void replace(Run run) {
    if (run.last - run.first == 1) return kept_.push_back(run.first);
    if (stabs(loop_, run) && deviation(loop_, run) <= tolerance_) {
      worst_ = std::max(worst_, regional_distortion(run));
      return kept_.push_back(run.first);
    }
    const std::size_t middle = run.first + cut(run);
    replace({run.first, middle});
    replace({middle, run.last});
  }

  [[nodiscard]] std::vector<std::size_t> take_kept() { return std::move(kept_); }
  [[nodiscard]] double worst_distortion() const { return worst_; }

 private:
  Vec2 point(std::size_t i) const {
    const GridPoint p = loop_.vertex(i);
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
  }

  // Equation (5).
  double regional_distortion(Run run) const {
    const Proxy line = line_through(point(run.first), point(run.last));
    double sum = 0;
    for (std::size_t i = run.first; i < run.last; ++i) {
      sum += distortion(point(i), point(i + 1), line);
    }
    return sum;
  }

  // Local clustering with two proxies; where it finds but one region, the middle.
  std::size_t cut(Run run) const {
    std::vector<Vec2> points;
    for (std::size_t i = run.first; i <= run.last; ++i) points.push_back(point(i));
    const auto first = cluster(points, Connection::kOpen, 2);
    return first.size() == 2 ? first[1] : (run.last - run.first) / 2;
  }

  const LoopView& loop_;
  double tolerance_;
  double worst_ = 0;
  std::vector<std::size_t> kept_;
};

}  // namespace

Simplified simplify_vsa(const ContourSet& contours, const SimplifyOptions& options) {
  OutlineBuilder builder(contours);
  const double unit = contours.grid().unit();
  const double tolerance = options.tolerance / unit;
  for (const ContourSet::Loop& loop : contours.loops()) {
    const LoopView view(contours, loop);
    const std::vector<std::size_t> first = vsa_regions(view, options.alpha);
    Verifier verifier(view, tolerance);
    for (std::size_t i = 0; i < first.size(); ++i) {
      verifier.replace({first[i], i + 1 < first.size() ? first[i + 1] : first[0] + loop.count});
    }
    builder.add(loop, verifier.take_kept());
    builder.note_distortion(verifier.worst_distortion() * unit * unit * unit);
  }
  return builder.finish();
}

}  // namespace slipstick
