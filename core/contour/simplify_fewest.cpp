#include <algorithm>

#include "core/contour/corridor.h"
#include "core/contour/edge_search.h"
#include "core/contour/farthest_seen.h"
#include "core/contour/frechet.h"
#include "core/contour/outline_builder.h"
#include "core/contour/simplify.h"

namespace slipstick {
namespace {

// Where the distance found is beyond the tolerance, windows are tightened there and the loop is
// searched again; after so many rounds all of them are.
constexpr int kRoundsMax = 3;

class FewestEdges {
 public:
  FewestEdges(const ContourSet& contours, const SimplifyOptions& options)
      : contours_(contours),
        tolerance_(options.tolerance / contours.grid().unit()),
        search_(options.candidates) {}

  Simplified run() {
    OutlineBuilder builder(contours_);
    for (const ContourSet::Loop& loop : contours_.loops()) {
      const LoopView view(contours_, loop);
      corridor_.build(view, tolerance_);
      search(view);
      builder.add(loop, search_.kept(), bounds_);
      const double width = contours_.grid().width();
      builder.note_distortion(search_.worst_distortion() * width * width * width);
    }
    return builder.finish();
  }

 private:
  void search(const LoopView& view) {
    const std::size_t start = settled_vertex();
    for (int round = 0;; ++round) {
      search_.run(corridor_, start);
      frechet_bounds(view, search_.kept(), bounds_);
      if (!tighten(round)) return;
    }
  }

  // Where to cut the loop open: a vertex of the greedy chain, half way round. Such chains soon
  // forget where they began.
  std::size_t settled_vertex() const {
    const std::size_t n = corridor_.size();
    std::size_t at = 0;
    while (at < n / 2) at = farthest_seen(corridor_, at, n);
    return at % n;
  }

  // Whether anything was too far and its window could be tightened.
  bool tighten(int round) {
    bool any = false;
    for (std::size_t i = 0; i < bounds_.size(); ++i) any |= bounds_[i] > tolerance_;
    if (!any || round > kRoundsMax) return false;
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      if (round == kRoundsMax || bounds_[i] > tolerance_) corridor_.tighten(i);
    }
    return true;
  }

  const ContourSet& contours_;
  const double tolerance_;
  Corridor corridor_;
  EdgeSearch search_;
  std::vector<double> bounds_;
};

}  // namespace

Simplified simplify_fewest(const ContourSet& contours, const SimplifyOptions& options) {
  return FewestEdges(contours, options).run();
}

}  // namespace slipstick
