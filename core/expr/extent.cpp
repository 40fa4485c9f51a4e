#include "core/expr/extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace slipstick {
namespace {

constexpr double kResolution = 1.0 / 512;
constexpr double kResolutionInZ = 1.0 / 4096;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double& coordinate(Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
double coordinate(const Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// A box cut across its longest side.
std::pair<Box3, Box3> halves(const Box3& box) {
  const Vec3 size = box.size();
  const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  Box3 low = box, high = box;
  coordinate(low.high, longest) = coordinate(high.low, longest) = coordinate(box.centre(), longest);
  return {low, high};
}

// Where the least value of a signed coordinate lies: nothing is below `certain`, something is at
// `known`.
struct Bracket {
  double certain = kInfinity;
  double known = kInfinity;
};

// Looks for the least value that one coordinate, or its negative, takes in the solid.
class Descent {
 public:
  Descent(const Box3& box, int axis, int sign, double tolerance)
      : box_(box), axis_(axis), sign_(sign), tolerance_(tolerance) {}

  Bracket run(const Tape& tape) {
    open(box_, std::make_shared<const Tape>(tape));
    for (int boxes = 0; !queue_.empty() && boxes < kExtentBoxesMax; ++boxes) {
      const Part part = queue_.top();
      if (part.least >= best_ - tolerance_) break;
      queue_.pop();
      probe(part);
      split(part);
    }
    const double open_end = queue_.empty() ? kInfinity : queue_.top().least;
    return {std::max(std::min(best_ - tolerance_, open_end), least_of(box_)), best_};
  }

 private:
  struct Part {
    double least;  // of the signed coordinate in the box
    Box3 box;
    std::shared_ptr<const Tape> tape;
    bool operator>(const Part& other) const { return least > other.least; }
  };

  double least_of(const Box3& box) const {
    return sign_ > 0 ? coordinate(box.low, axis_) : -coordinate(box.high, axis_);
  }

  void open(const Box3& box, const std::shared_ptr<const Tape>& tape) {
    Pruned pruned = prune(*tape, box);
    if (pruned.range.low > 0 && !pruned.range.may_be_nan) return;
    auto shorter =
        pruned.tape.steps.empty() ? tape : std::make_shared<const Tape>(std::move(pruned.tape));
    queue_.push({least_of(box), box, std::move(shorter)});
  }

  bool inside(const Part& part, const Vec3& p) {
    return evaluator_.evaluate(*part.tape, {&p.x, 1}, {&p.y, 1}, p.z)[0] <= 0;
  }

  // From an inside point go down to the boundary or the box's side.
  void probe(const Part& part) {
    constexpr int kHalvings = 24;
    Vec3 p = part.box.centre();
    if (!inside(part, p)) return;
    double in = coordinate(p, axis_);
    double out = sign_ > 0 ? coordinate(part.box.low, axis_) : coordinate(part.box.high, axis_);
    for (int i = 0; i < kHalvings; ++i) {
      coordinate(p, axis_) = (in + out) / 2;
      (inside(part, p) ? in : out) = coordinate(p, axis_);
    }
    best_ = std::min(best_, sign_ * in);
  }

  // What lies above the best found so far is of no interest; the rest is halved along its longest
  // side.
  void split(const Part& part) {
    Box3 box = part.box;
    if (best_ != kInfinity) {
      const double end = sign_ * (best_ - tolerance_);
      double& side = coordinate(sign_ > 0 ? box.high : box.low, axis_);
      side = sign_ > 0 ? std::min(side, end) : std::max(side, end);
    }
    const auto [low, high] = halves(box);
    open(low, part.tape);
    open(high, part.tape);
  }

  Box3 box_;
  int axis_;
  int sign_;
  double tolerance_;
  double best_ = kInfinity;  // least signed coordinate of a point known to be inside
  std::priority_queue<Part, std::vector<Part>, std::greater<>> queue_;
  TapeEvaluator evaluator_;
};

// Asks of whole planes whether the solid meets them, on a raster: for expressions whose intervals
// are too wide to say more.
class PlaneScan {
 public:
  PlaneScan(const Tape& tape, const Box3& box, int axis) : tape_(tape), box_(box), axis_(axis) {}

  // The first of the planes from `from` to `to`, `step` apart, that is met, and the last that is
  // not, halved until they are close. \return The latter; `to` if none is met before.
  double first_met(double from, double to, double step) {
    const int count = static_cast<int>(std::ceil(std::abs(to - from) / step));
    const double signed_step = to > from ? step : -step;
    for (int i = 1; i < count; ++i) {
      const double at = from + i * signed_step;
      if (is_met(at)) return refined(at - signed_step, at);
    }
    return to;
  }

 private:
  // A raster of 256 by 256: ten halvings of a plane, then 8 by 8 points.
  static constexpr int kDepth = 16;
  static constexpr int kBatchDepth = 6;
  static constexpr int kBatchSide = 8;
  static constexpr int kHalvings = 5;

  double refined(double free, double met) {
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (free + met) / 2;
      (is_met(middle) ? met : free) = middle;
    }
    return free;
  }

  bool is_met(double at) {
    Box3 plane = box_;
    coordinate(plane.low, axis_) = coordinate(plane.high, axis_) = at;
    return is_met(plane, tape_, kDepth);
  }

  bool is_met(const Box3& part, const Tape& tape, int depth) {
    const Pruned pruned = prune(tape, part);
    if (!pruned.range.may_be_nan && pruned.range.low > 0) return false;
    if (!pruned.range.may_be_nan && pruned.range.high <= 0) return true;
    const Tape& shorter = pruned.tape.steps.empty() ? tape : pruned.tape;
    if (depth == kBatchDepth) return is_any_inside(part, shorter);
    const auto [low, high] = halves(part);
    return is_met(low, shorter, depth - 1) || is_met(high, shorter, depth - 1);
  }

  // The middles of 8 by 8 parts; along a row z stays the same.
  bool is_any_inside(const Box3& part, const Tape& tape) {
    const int along = axis_ == 0 ? 1 : 0, across = 3 - axis_ - along;
    std::array<double, kBatchSide> xs{}, ys{};
    for (int row = 0; row < kBatchSide; ++row) {
      Vec3 p = part.centre();
      coordinate(p, across) = at_part(part, across, row);
      for (int i = 0; i < kBatchSide; ++i) {
        coordinate(p, along) = at_part(part, along, i);
        xs[static_cast<std::size_t>(i)] = p.x;
        ys[static_cast<std::size_t>(i)] = p.y;
      }
      for (const double f : evaluator_.evaluate(tape, xs, ys, p.z)) {
        if (f <= 0) return true;
      }
    }
    return false;
  }

  static double at_part(const Box3& part, int axis, int i) {
    const double low = coordinate(part.low, axis), size = coordinate(part.high, axis) - low;
    return low + (i + 0.5) / kBatchSide * size;
  }

  const Tape& tape_;
  const Box3& box_;
  int axis_;
  TapeEvaluator evaluator_;
};

// Bound of one side: sign 1 for the low side, -1 for the high one. Nothing if nothing is inside.
std::optional<double> side(const Tape& tape, const Box3& box, int axis, int sign) {
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  const double tolerance = (axis == 2 ? kResolutionInZ : kResolution) * largest;
  const Bracket found = Descent(box, axis, sign, tolerance).run(tape);
  if (found.certain == kInfinity) return {};
  if (found.known - found.certain <= 2 * tolerance) return sign * found.certain;
  const double end = found.known == kInfinity ? coordinate(sign > 0 ? box.high : box.low, axis)
                                              : sign * found.known;
  return PlaneScan(tape, box, axis).first_met(sign * found.certain, end, kResolution * largest);
}

}  // namespace

Box3 extent(const Tape& tape, const Box3& box) {
  if (box.empty()) return {};
  Box3 result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto low = side(tape, box, axis, 1);
    const auto high = side(tape, box, axis, -1);
    if (!low || !high || *low >= *high) return {};
    coordinate(result.low, axis) = *low;
    coordinate(result.high, axis) = *high;
  }
  return result;
}

}  // namespace slipstick
