#include "core/contour/certify_column.h"

#include <limits>

namespace slipstick {
namespace {

class ColumnJudge {
 public:
  explicit ColumnJudge(Field& field) : field_(field) {}

  void look(const Box3& box, int splits) {
    ++boxes_;
    const GradientRange range = field_.over(box);
    if (range.no_surface()) return;
    const bool harmless = no_critical_point(range);
    const bool one_way = range.z.never_falls() || range.z.never_rises();
    if (!one_way && splits > 0) return split(box, splits - 1);
    begins_ |= !range.z.never_falls();
    ends_ |= !range.z.never_rises();
    if (harmless) return;
    low_ = std::min(low_, box.low.z);
    high_ = std::max(high_, box.high.z);
  }

  [[nodiscard]] ColumnVerdict verdict() const {
    if (low_ > high_) return {{}, 0, 0, boxes_};
    const bool twice = begins_ && ends_;
    return {twice ? SlabEvent::Kind::kHidden : SlabEvent::Kind::kStep, low_, high_, boxes_};
  }

 private:
  void split(const Box3& box, int splits) {
    const Vec3 c = box.centre();
    for (int part = 0; part < 8; ++part) {
      Box3 b = box;
      ((part & 1) != 0 ? b.low.x : b.high.x) = c.x;
      ((part & 2) != 0 ? b.low.y : b.high.y) = c.y;
      ((part & 4) != 0 ? b.low.z : b.high.z) = c.z;
      look(b, splits);
    }
  }

  Field& field_;
  // Whether, going up, the solid may begin somewhere in the column, and may end.
  bool begins_ = false;
  bool ends_ = false;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
  std::int64_t boxes_ = 0;
};

}  // namespace

bool no_critical_point(const GradientRange& range) {
  return range.x.never_zero() || range.y.never_zero() || range.rising.never_zero() ||
         range.falling.never_zero();
}

ColumnVerdict judge_column(Field& field, const Box3& column) {
  ColumnJudge judge(field);
  judge.look(column, kEventSplits);
  return judge.verdict();
}

}  // namespace slipstick
