#include "core/contour/edge_search.h"

#include <algorithm>

#include "core/base/check.h"

namespace slipstick {
namespace {

template <typename Number>
Ray<Number> between(Ray<double> from, Ray<double> to) {
  return {static_cast<Number>(to.x - from.x), static_cast<Number>(to.y - from.y)};
}

constexpr std::size_t first_of(Candidates used) {
  return used == Candidates::kOne ? Corridor::kOwnPlace : 0;
}
constexpr std::size_t end_of(Candidates used) {
  return used == Candidates::kOne ? Corridor::kOwnPlace + 1 : Corridor::kCandidates;
}

}  // namespace

void EdgeSearch::run(const Corridor& corridor, std::size_t start) {
  prepare(corridor, start);
  constexpr std::size_t kOwn = Corridor::kOwnPlace;
  best_[kOwn] = {0, 0, 0};
  reached_.assign(1, kOwn);
  while (best_[n_ * kCandidates + kOwn].edges == kNever) {
    // A stick always sees the next one.
    SLIPSTICK_DCHECK(!reached_.empty());
    next_.clear();
    look_from_all();
    std::swap(reached_, next_);
  }
  collect(corridor);
}

void EdgeSearch::prepare(const Corridor& corridor, std::size_t start) {
  start_ = start;
  n_ = corridor.size();
  moments_.build(corridor, start);
  best_.assign((n_ + 1) * kCandidates, {});
  points_.resize(n_ + 1);
  const GridPoint origin = corridor.points(start)[Corridor::kOwnPlace];
  for (std::size_t k = 0, i = start; k <= n_; ++k, i = i + 1 < n_ ? i + 1 : 0) {
    for (std::size_t c = 0; c < kCandidates; ++c) {
      const GridPoint p = corridor.points(i)[c];
      points_[k][c] = {static_cast<double>(p.x) - origin.x, static_cast<double>(p.y) - origin.y};
    }
  }
}

void EdgeSearch::look_from_all() {
  const std::uint32_t farthest = *std::max_element(reached_.begin(), reached_.end());
  const std::size_t last = farthest / kCandidates;
  const std::size_t first = last < kOriginSticks ? 0 : (last - kOriginSticks + 1) * kCandidates;
  for (const std::uint32_t state : reached_) {
    if (state < first) continue;
    candidates_ == Candidates::kOne ? look_from<Candidates::kOne>(state)
                                    : look_from<Candidates::kThree>(state);
  }
}

template <Candidates kUsed>
void EdgeSearch::look_from(std::uint32_t state) {
  const std::size_t k = state / kCandidates, c = state % kCandidates;
  const Origin origin{k, c, points_[k][c], best_[state]};
  const Points& next = points_[k + 1];
  Wedge<double> wedge(between<double>(origin.point, next.front()),
                      between<double>(origin.point, next.back()));
  for (std::size_t d = first_of(kUsed); d < end_of(kUsed); ++d) {
    if (improves(origin.best, best_[(k + 1) * kCandidates + d])) reach(origin, k + 1, d);
  }
  const std::size_t near = std::min(n_, k + Wedge<double>::kSpanMax);
  if (!look<kUsed>(origin, wedge, k + 2, near)) return;
  Wedge<std::int64_t> exact(wedge);
  static_cast<void>(
      look<kUsed>(origin, exact, near + 1, std::min(n_, k + Wedge<std::int64_t>::kSpanMax)));
}

// Reaches what is seen of sticks `first` to `end`. \return false if nothing is seen behind them.
template <Candidates kUsed, typename Number>
bool EdgeSearch::look(const Origin& origin, Wedge<Number>& wedge, std::size_t first,
                      std::size_t end) {
  for (std::size_t j = first; j <= end; ++j) {
    const auto inner = between<Number>(origin.point, points_[j].front());
    const auto outer = between<Number>(origin.point, points_[j].back());
    if (!wedge.meets(inner, outer)) return false;
    for (std::size_t d = first_of(kUsed); d < end_of(kUsed); ++d) {
      if (!improves(origin.best, best_[j * kCandidates + d])) continue;
      if (wedge.sees(between<Number>(origin.point, points_[j][d]))) reach(origin, j, d);
    }
    if (!wedge.pass(inner, outer)) return false;
  }
  return true;
}

// Whether one edge more from `origin` may be better: distortion only grows along the way.
bool EdgeSearch::improves(const Best& origin, const Best& to) {
  return to.edges > origin.edges + 1 ||
         (to.edges == origin.edges + 1 && origin.distortion < to.distortion);
}

void EdgeSearch::reach(const Origin& origin, std::size_t stick, std::size_t candidate) {
  const auto state = static_cast<std::uint32_t>(stick * kCandidates + candidate);
  Best& to = best_[state];
  const std::int32_t edges = origin.best.edges + 1;
  if (stick == n_ && candidate != Corridor::kOwnPlace) return;
  const double distortion =
      origin.best.distortion +
      moments_.distortion(origin.stick, stick, origin.point, points_[stick][candidate]);
  if (to.edges == edges && !(distortion < to.distortion)) return;
  if (to.edges == kNever) next_.push_back(state);
  const std::size_t from = origin.stick * kCandidates + origin.candidate;
  to = {edges, static_cast<std::uint32_t>(from), distortion};
}

void EdgeSearch::collect(const Corridor& corridor) {
  kept_.clear();
  worst_distortion_ = 0;
  std::size_t state = n_ * kCandidates + Corridor::kOwnPlace;
  while (state >= kCandidates) {
    const std::size_t from = best_[state].from;
    worst_distortion_ =
        std::max(worst_distortion_, best_[state].distortion - best_[from].distortion);
    state = from;
    const std::size_t i = (start_ + state / kCandidates) % n_, c = state % kCandidates;
    kept_.push_back({i, corridor.place(i, c)});
  }
  const auto first = std::min_element(
      kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.index < b.index; });
  // Found backwards: after reversing, the loop's own order begins at its least index.
  std::rotate(kept_.begin(), first + 1, kept_.end());
  std::reverse(kept_.begin(), kept_.end());
}

}  // namespace slipstick
