#include <numeric>
#include <vector>

#include "core/contour/corridor.h"
#include "core/contour/farthest_seen.h"
#include "core/contour/outline_builder.h"
#include "core/contour/simplify.h"

namespace slipstick {
namespace {

bool fits(const LoopView& loop, Run run, double tolerance) {
  return stabs(loop, run) && deviation(loop, run) <= tolerance;
}

// The farthest vertex, up to `limit`, found by doubling and halving. Not always the farthest of
// all: a longer run may fit where a shorter one does not, but looking at each would cost the
// square.
std::size_t reach(const LoopView& loop, std::size_t from, std::size_t limit, double tolerance) {
  std::size_t good = from + 1;
  std::size_t stride = 1;
  while (good + stride <= limit && fits(loop, {from, good + stride}, tolerance)) {
    good += stride;
    stride *= 2;
  }
  for (; stride > 0; stride /= 2) {
    if (good + stride <= limit && fits(loop, {from, good + stride}, tolerance)) good += stride;
  }
  return good;
}

class GreedyEdges {
 public:
  GreedyEdges(const ContourSet& contours, double tolerance)
      : contours_(contours), tolerance_(tolerance) {}

  Simplified run() {
    OutlineBuilder builder(contours_);
    for (const ContourSet::Loop& loop : contours_.loops()) {
      const LoopView view(contours_, loop);
      corridor_.build(view, tolerance_);
      kept_.clear();
      for (std::size_t at = 0; at < loop.count; at = next(view, at)) kept_.push_back(at);
      builder.add(loop, kept_);
    }
    return builder.finish();
  }

 private:
  // What is seen through the windows is within the tolerance to first order: nearly always.
  std::size_t next(const LoopView& loop, std::size_t from) const {
    const std::size_t seen = farthest_seen(corridor_, from, loop.size());
    return deviation(loop, {from, seen}) <= tolerance_ ? seen : reach(loop, from, seen, tolerance_);
  }

  const ContourSet& contours_;
  const double tolerance_;
  Corridor corridor_;
  std::vector<std::size_t> kept_;
};

}  // namespace

Simplified simplify_greedy(const ContourSet& contours, const SimplifyOptions& options) {
  return GreedyEdges(contours, options.tolerance / contours.grid().unit()).run();
}

Simplified keep_all(const ContourSet& contours) {
  OutlineBuilder builder(contours);
  for (const ContourSet::Loop& loop : contours.loops()) {
    std::vector<std::size_t> all(loop.count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    builder.add(loop, all);
  }
  return builder.finish();
}

}  // namespace slipstick
