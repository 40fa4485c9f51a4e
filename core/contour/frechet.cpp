#include "core/contour/frechet.h"

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

struct Foot {
  double at = 0;  // 0 to 1 along the segment
  double distance = 0;
};

Vec2 exact(GridPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

// The nearest point to `p` of the segment from a to b, not before `first`.
Foot foot(Vec2 p, Vec2 a, Vec2 b, double first) {
  const Vec2 edge = b - a;
  const double square = dot(edge, edge);
  const double at = square > 0 ? std::clamp(dot(p - a, edge) / square, first, 1.0) : 1.0;
  const Vec2 away = p - a - at * edge;
  return {at, std::sqrt(dot(away, away))};
}

class Matching {
 public:
  Matching(const LoopView& loop, std::span<const Kept> kept, std::vector<double>& bounds)
      : loop_(loop), kept_(kept), bounds_(bounds) {}

  void run() {
    bounds_.assign(loop_.size(), 0);
    double first = leave(0).at;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const double last = between(i, first);
      first = i + 1 < kept_.size() ? turn(i + 1, last) : 0;
    }
  }

 private:
  Vec2 corner(std::size_t i) const {
    const Kept& k = kept_[i % kept_.size()];
    return exact(position(loop_.stick(k.index), k.place));
  }
  Vec2 vertex(std::size_t i) const { return exact(loop_.vertex(i)); }

  // The vertex of corner i goes with its foot on the edge that leaves, and the corner with the
  // nearest point of the piece of the loop that arrives.
  Foot leave(std::size_t i) {
    const std::size_t at = kept_[i].index;
    const Vec2 c = corner(i), v = vertex(at);
    Foot f = foot(v, c, corner(i + 1), 0);
    f.distance = std::max(f.distance, foot(c, vertex(at + loop_.size() - 1), v, 0).distance);
    if (i == 0) note(at, f.distance);
    return f;
  }

  // Or with its foot on the edge that arrives, behind `last`, and the corner with the piece that
  // leaves: whichever is nearer. \return where skipped vertices may begin on the edge that leaves.
  double turn(std::size_t i, double last) {
    const std::size_t at = kept_[i].index;
    const Vec2 c = corner(i), v = vertex(at);
    const Foot after = leave(i);
    const double before =
        std::max(foot(v, corner(i - 1), c, last).distance, foot(c, v, vertex(at + 1), 0).distance);
    note(at, std::min(before, after.distance));
    return before < after.distance ? 0 : after.at;
  }

  // The skipped vertices of edge i, the first not before `first`. \return where the last one is.
  double between(std::size_t i, double first) {
    const bool wraps = i + 1 == kept_.size();
    const std::size_t end = wraps ? kept_[0].index + loop_.size() : kept_[i + 1].index;
    const Vec2 a = corner(i), b = corner(i + 1);
    for (std::size_t k = kept_[i].index + 1; k < end; ++k) {
      const Foot f = foot(vertex(k), a, b, first);
      note(k, f.distance);
      first = f.at;
    }
    return first;
  }

  void note(std::size_t vertex, double distance) {
    double& bound = bounds_[vertex % loop_.size()];
    bound = std::max(bound, distance);
  }

  const LoopView& loop_;
  const std::span<const Kept> kept_;
  std::vector<double>& bounds_;
};

}  // namespace

void frechet_bounds(const LoopView& loop, std::span<const Kept> kept, std::vector<double>& bounds) {
  Matching(loop, kept, bounds).run();
}

}  // namespace slipstick
