#include "tests/support/lower_bound.h"

#include <algorithm>
#include <limits>

#include "core/contour/corridor.h"

namespace slipstick::test {
namespace {

constexpr int kSearchSteps = 60;
// In 1/65536 of a cell: what rounding may do to a gap. Taking a run that no line stabs for one that
// can be stabbed only makes the bound lower.
constexpr double kDoubt = 1e-3;

// A run of windows, from the inside end of each to the outside end.
class Run {
 public:
  Run(const Corridor& corridor, std::size_t first) : corridor_(corridor), first_(first) {}

  // Whether a line leaves the inside ends of the first `count` windows on its left and the outside
  // ends on its right.
  [[nodiscard]] bool stabbed(std::size_t count) const {
    const Vec2 origin = end(0, 1), far = end(count - 1, 1);
    const Vec2 along = far - origin;
    if (count < 3 || (along.x == 0 && along.y == 0)) return count < 3;
    // The widest gap is a concave function of the line's slope against `along`.
    double low = -1, high = 1;  // slope = t / (1 - |t|)
    for (int i = 0; i < kSearchSteps; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      if (gap(count, a, along) < gap(count, b, along)) {
        low = a;
      } else {
        high = b;
      }
    }
    return gap(count, (low + high) / 2, along) > -kDoubt;
  }

 private:
  Vec2 end(std::size_t k, std::size_t candidate) const {
    const GridPoint p = corridor_.points((first_ + k) % corridor_.size())[candidate];
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
  }

  // How far left of the line all inside ends stay, less how far right the outside ends: along the
  // line's normal.
  double gap(std::size_t count, double t, Vec2 along) const {
    const double slope = std::clamp(t, -0.999, 0.999) / (1 - std::min(0.999, std::abs(t)));
    const Vec2 direction{along.x - slope * along.y, along.y + slope * along.x};
    const double length = std::sqrt(dot(direction, direction));
    const Vec2 left{-direction.y / length, direction.x / length};
    double nearest = std::numeric_limits<double>::max(), farthest = -nearest;
    for (std::size_t k = 0; k < count; ++k) {
      nearest = std::min(nearest, dot(left, end(k, 0)));
      farthest = std::max(farthest, dot(left, end(k, 2)));
    }
    return nearest - farthest;
  }

  const Corridor& corridor_;
  std::size_t first_;
};

std::size_t longest_run(const Corridor& corridor, std::size_t first, std::size_t limit) {
  const Run run(corridor, first);
  std::size_t count = std::min<std::size_t>(2, limit);
  while (count < limit && run.stabbed(count + 1)) ++count;
  return count;
}

std::size_t runs_from(const Corridor& corridor, std::size_t start) {
  std::size_t runs = 0;
  for (std::size_t done = 0; done < corridor.size(); ++runs) {
    done += longest_run(corridor, start + done, corridor.size() - done);
  }
  return runs;
}

}  // namespace

std::size_t fewest_edges_bound(const ContourSet& contours, double tolerance) {
  std::size_t sum = 0;
  Corridor corridor;
  for (const ContourSet::Loop& loop : contours.loops()) {
    corridor.build(LoopView(contours, loop), tolerance / contours.grid().unit());
    const std::size_t starts = longest_run(corridor, 0, corridor.size());
    std::size_t fewest = corridor.size();
    for (std::size_t start = 0; start < starts; ++start) {
      fewest = std::min(fewest, runs_from(corridor, start));
    }
    sum += std::max<std::size_t>(fewest, 3);
  }
  return sum;
}

}  // namespace slipstick::test
