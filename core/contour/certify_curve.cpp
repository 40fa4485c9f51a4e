#include "core/contour/certify_curve.h"

#include <algorithm>
#include <array>

namespace slipstick {
namespace {

// In which way f goes in a box.
using Way = bool (*)(const GradientRange&);

bool no_way(const GradientRange& /*range*/) {
  return false;
}

constexpr std::array<Way, 2> kAlongX{[](const GradientRange& r) { return r.x.low > 0; },
                                     [](const GradientRange& r) { return r.x.high < 0; }};
constexpr std::array<Way, 2> kAlongY{[](const GradientRange& r) { return r.y.low > 0; },
                                     [](const GradientRange& r) { return r.y.high < 0; }};
constexpr std::array<Way, 4> kAlongDiagonals{
    [](const GradientRange& r) { return r.rising.low > 0; },
    [](const GradientRange& r) { return r.rising.high < 0; },
    [](const GradientRange& r) { return r.falling.low > 0; },
    [](const GradientRange& r) { return r.falling.high < 0; }};

class CurveJudge {
 public:
  explicit CurveJudge(Field& field) : field_(field) {}

  [[nodiscard]] CurveVerdict judge(const Box3& square) {
    const bool certified = goes_one(kAlongX, square) || goes_one(kAlongY, square) ||
                           (goes_one(kAlongDiagonals, square) && sides_part(square));
    return {certified, boxes_};
  }

 private:
  template <std::size_t kCount>
  [[nodiscard]] bool goes_one(const std::array<Way, kCount>& ways, const Box3& box) {
    return std::any_of(ways.begin(), ways.end(),
                       [&](Way way) { return goes(way, box, kSquareSplits); });
  }

  // Whether f goes this way wherever the curve may be in the box.
  [[nodiscard]] bool goes(Way way, const Box3& box, int splits) {
    ++boxes_;
    const GradientRange range = field_.over(box);
    if (range.no_surface() || way(range)) return true;
    if (splits == 0) return false;
    const Vec3 c = box.centre();
    const bool wide = box.low.x < box.high.x, high = box.low.y < box.high.y;
    for (int part = 0; part < 4; ++part) {
      if (((part & 1) != 0 && !wide) || ((part & 2) != 0 && !high)) continue;
      Box3 b = box;
      if (wide) ((part & 1) != 0 ? b.low.x : b.high.x) = c.x;
      if (high) ((part & 2) != 0 ? b.low.y : b.high.y) = c.y;
      if (!goes(way, b, splits - 1)) return false;
    }
    return true;
  }

  // Whether the curve meets each side once at most, and one not at all.
  [[nodiscard]] bool sides_part(const Box3& square) {
    Box3 left = square, right = square, bottom = square, top = square;
    left.high.x = square.low.x;
    right.low.x = square.high.x;
    bottom.high.y = square.low.y;
    top.low.y = square.high.y;
    int met = 0;
    for (const Box3& side : {left, right, bottom, top}) {
      if (goes(no_way, side, kSquareSplits)) continue;
      if (!goes_one(side.low.x < side.high.x ? kAlongX : kAlongY, side)) return false;
      ++met;
    }
    return met < 4;
  }

  Field& field_;
  std::int64_t boxes_ = 0;
};

}  // namespace

CurveVerdict judge_curve(Field& field, const Box3& square) {
  return CurveJudge(field).judge(square);
}

}  // namespace slipstick
