#include "core/expr/extent.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
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

// Looks for the least value that one coordinate, or its negative, takes in the solid.
class Descent {
 public:
  Descent(const Box3& box, int axis, int sign, double tolerance)
      : box_(box), axis_(axis), sign_(sign), tolerance_(tolerance) {}

  // Nothing if the solid is empty.
  std::optional<double> run(const Tape& tape) {
    open(box_, std::make_shared<const Tape>(tape));
    for (int boxes = 0; !queue_.empty() && boxes < kExtentBoxesMax; ++boxes) {
      const Part part = queue_.top();
      if (part.least >= best_ - tolerance_) break;
      queue_.pop();
      probe(part);
      split(part);
    }
    const double certain = queue_.empty() ? kInfinity : queue_.top().least;
    const double least = std::min(best_ - tolerance_, certain);
    if (least == kInfinity) return {};
    return std::max(sign_ * least, sign_ > 0 ? coordinate(box_.low, axis_) : -kInfinity);
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
    const Vec3 size = box.size();
    const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Box3 low = box, high = box;
    coordinate(low.high, longest) = coordinate(high.low, longest) =
        coordinate(box.centre(), longest);
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

}  // namespace

Box3 extent(const Tape& tape, const Box3& box) {
  if (box.empty()) return {};
  const Vec3 size = box.size();
  Box3 result;
  for (int axis = 0; axis < 3; ++axis) {
    const double tolerance =
        (axis == 2 ? kResolutionInZ : kResolution) * std::max({size.x, size.y, size.z});
    const auto low = Descent(box, axis, 1, tolerance).run(tape);
    const auto high = Descent(box, axis, -1, tolerance).run(tape);
    if (!low || !high) return {};
    coordinate(result.low, axis) = *low;
    coordinate(result.high, axis) = std::min(*high, coordinate(box.high, axis));
  }
  return result;
}

}  // namespace slipstick
