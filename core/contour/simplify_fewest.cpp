#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/contour/corridor.h"
#include "core/contour/frechet.h"
#include "core/contour/outline_builder.h"
#include "core/contour/prefix_moments.h"
#include "core/contour/simplify.h"
#include "core/contour/wedge.h"

namespace slipstick {
namespace {

constexpr std::size_t kCandidates = Corridor::kCandidates;
// Where the distance found is beyond the tolerance, windows are tightened there and the loop is
// searched again; after so many rounds all of them are.
constexpr int kRoundsMax = 3;

// The last stick up to `limit` whose own place is seen from that of stick `from`.
std::size_t farthest_seen(const Corridor& corridor, std::size_t from, std::size_t limit) {
  const auto points = [&](std::size_t k) -> const auto& {
    return corridor.points(k < corridor.size() ? k : k - corridor.size());
  };
  std::size_t seen = from + 1;
  const std::size_t end = std::min(limit, from + Wedge::kSpanMax);
  Wedge wedge(points(from)[Corridor::kOwnPlace], points(seen).front(), points(seen).back());
  for (std::size_t k = from + 2; k <= end; ++k) {
    if (wedge.sees(points(k)[Corridor::kOwnPlace])) seen = k;
    if (!wedge.pass(points(k).front(), points(k).back())) break;
  }
  return seen;
}

// The dynamic programme over (stick, candidate) of one loop, cut open at a vertex. Keeps its memory
// from loop to loop.
class Search {
 public:
  // The cheapest way once round, from and back to `start`. Ascending by index.
  void run(const Corridor& corridor, Kept start, std::size_t start_candidate) {
    corridor_ = &corridor;
    start_ = start.index;
    n_ = corridor.size();
    moments_.build(corridor, start_);
    best_.assign((n_ + 1) * kCandidates, {});
    at(0, start_candidate) = {0, 0, 0};
    last_candidate_ = start_candidate;
    for (std::size_t k = 0; k < n_; ++k) {
      for (std::size_t c = 0; c < kCandidates; ++c) {
        if (at(k, c).edges != kNever) look_from(k, c);
      }
    }
    collect();
  }

  [[nodiscard]] const std::vector<Kept>& kept() const { return kept_; }

 private:
  static constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

  struct Best {
    std::int32_t edges = kNever;
    std::uint32_t from = 0;  // (stick, candidate) as one number
    double distortion = 0;
  };

  Best& at(std::size_t k, std::size_t c) { return best_[k * kCandidates + c]; }
  const std::array<GridPoint, kCandidates>& points(std::size_t k) const {
    const std::size_t i = start_ + k;
    return corridor_->points(i < n_ ? i : i - n_);
  }

  void look_from(std::size_t k, std::size_t c) {
    const GridPoint origin = points(k)[c];
    const std::size_t end = std::min(n_, k + Wedge::kSpanMax);
    const auto& next = points(k + 1);
    Wedge wedge(origin, next.front(), next.back());
    for (std::size_t j = k + 1;; ++j) {
      reach(k, c, j, j == k + 1 ? nullptr : &wedge);
      if (j == end) return;
      if (j > k + 1 && !wedge.pass(points(j).front(), points(j).back())) return;
    }
  }

  // Relaxes the candidates of stick j that are seen.
  void reach(std::size_t k, std::size_t c, std::size_t j, const Wedge* wedge) {
    const Best from = at(k, c);
    for (std::size_t d = 0; d < kCandidates; ++d) {
      if (j == n_ && d != last_candidate_) continue;
      Best& to = at(j, d);
      if (from.edges + 1 > to.edges) continue;
      // Distortion only grows along the way.
      if (from.edges + 1 == to.edges && from.distortion >= to.distortion) continue;
      const GridPoint point = points(j)[d];
      if (wedge != nullptr && !wedge->sees(point)) continue;
      const double sum = from.distortion + moments_.distortion(k, j, points(k)[c], point);
      if (from.edges + 1 == to.edges && !(sum < to.distortion)) continue;
      to = {from.edges + 1, static_cast<std::uint32_t>(k * kCandidates + c), sum};
    }
  }

  void collect() {
    kept_.clear();
    std::size_t state = n_ * kCandidates + last_candidate_;
    while (state >= kCandidates) {
      state = best_[state].from;
      const std::size_t i = (start_ + state / kCandidates) % n_, c = state % kCandidates;
      kept_.push_back({i, corridor_->place(i, c)});
    }
    const auto first = std::min_element(
        kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.index < b.index; });
    // Found backwards: after reversing, the loop's own order begins at its least index.
    const auto turn = first - kept_.begin() + 1;
    std::rotate(kept_.begin(), kept_.begin() + turn, kept_.end());
    std::reverse(kept_.begin(), kept_.end());
  }

  const Corridor* corridor_ = nullptr;
  std::size_t start_ = 0;
  std::size_t n_ = 0;
  std::size_t last_candidate_ = 0;
  PrefixMoments moments_;
  std::vector<Best> best_;
  std::vector<Kept> kept_;
};

class FewestEdges {
 public:
  FewestEdges(const ContourSet& contours, double tolerance)
      : contours_(contours), tolerance_(tolerance) {}

  Simplified run() {
    OutlineBuilder builder(contours_);
    for (const ContourSet::Loop& loop : contours_.loops()) {
      const LoopView view(contours_, loop);
      corridor_.build(view, tolerance_);
      search(view);
      builder.add(loop, search_.kept(), bounds_);
    }
    return builder.finish();
  }

 private:
  void search(const LoopView& view) {
    const std::size_t start = settled_vertex();
    for (int round = 0;; ++round) {
      search_.run(corridor_, {start, {}}, Corridor::kOwnPlace);
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
  Search search_;
  std::vector<double> bounds_;
};

}  // namespace

Simplified simplify_fewest(const ContourSet& contours, const SimplifyOptions& options) {
  return FewestEdges(contours, options.tolerance / contours.grid().unit()).run();
}

}  // namespace slipstick
