#include <algorithm>
#include <numeric>

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

std::vector<std::size_t> kept_vertices(const LoopView& loop, double tolerance) {
  std::vector<std::size_t> kept;
  for (std::size_t at = 0; at < loop.size(); at = reach(loop, at, loop.size(), tolerance)) {
    kept.push_back(at);
  }
  return kept;
}

}  // namespace

Simplified simplify_greedy(const ContourSet& contours, const SimplifyOptions& options) {
  OutlineBuilder builder(contours);
  const double tolerance = options.tolerance / contours.grid().unit();
  for (const ContourSet::Loop& loop : contours.loops()) {
    builder.add(loop, kept_vertices(LoopView(contours, loop), tolerance));
  }
  return builder.finish();
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
