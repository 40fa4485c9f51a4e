#include "core/solid/mesh_model_section.h"

#include <algorithm>
#include <limits>

#include "core/base/check.h"
#include "core/image/bit_image.h"

namespace slipstick {
namespace {

// Sections of fewer segments are searched one by one.
constexpr std::size_t kIndexedMin = 32;

bool crosses(const OutlineSegment& s, double y) {
  return s.low.y <= y && y < s.high.y;
}

// Clamped, so that a segment that lies beside a point is counted as lying beside it in spite of
// rounding; `narrowed` relies on it.
double crossing_x(const OutlineSegment& s, double y) {
  const double share = (y - s.low.y) / (s.high.y - s.low.y);
  const double x = s.low.x + share * (s.high.x - s.low.x);
  return std::clamp(x, std::min(s.low.x, s.high.x), std::max(s.low.x, s.high.x));
}

}  // namespace

OutlineSection::OutlineSection(std::vector<OutlineSegment> segments, Closedness closedness,
                               Winding winding, int turns)
    : segments_(std::move(segments)), closedness_(closedness), winding_(winding), turns_(turns) {}

int OutlineSection::counted(int turn) const {
  return winding_ == Winding::kNonzero ? turn : 1;
}

bool OutlineSection::is_inside(int turns) const {
  return winding_ == Winding::kNonzero ? turns != 0 : turns % 2 != 0;
}

void OutlineSection::classify(std::span<const double> xs, std::span<const double> ys,
                              std::span<std::uint8_t> inside) {
  SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == inside.size());
  for (std::size_t i = 0; i < xs.size(); ++i) {
    inside[i] = contains({xs[i], ys[i]}) ? std::uint8_t{1} : std::uint8_t{0};
  }
}

// Segments above, below and to the right of the box never count in it and are dropped; those that
// pass it on the left from below to above count for all its points, so their turns are kept and not
// they. If none of the others touches it, a closed outline passes it on the left as a whole, so
// that all its points have one answer; an open one may end there.
Section::Narrowed OutlineSection::narrowed(const Box2& box) {
  std::vector<OutlineSegment> kept;
  bool touched = false;
  int turns = turns_;
  for (const OutlineSegment& s : segments_) {
    if (s.high.y <= box.low.y || s.low.y > box.high.y) continue;
    if (std::min(s.low.x, s.high.x) > box.high.x) continue;
    const bool on_the_left = std::max(s.low.x, s.high.x) < box.low.x;
    touched = touched || !on_the_left;
    if (on_the_left && s.low.y <= box.low.y && s.high.y > box.high.y) {
      turns += counted(s.turn);
    } else {
      kept.push_back(s);
    }
  }
  if (kept.empty()) return {is_inside(turns) ? Cover::kInside : Cover::kOutside, nullptr};
  if (!touched && closedness_ == Closedness::kClosed) {
    return {contains(box.low) ? Cover::kInside : Cover::kOutside, nullptr};
  }
  return {Cover::kMixed,
          std::make_unique<OutlineSection>(std::move(kept), closedness_, winding_, turns)};
}

bool OutlineSection::paint(BitImage& image) {
  const SliceGrid& grid = image.grid();
  const int last = image.columns() - 1;  // Of the ring, which stays empty.
  // The first column at or to the right of x.
  const auto column_at = [&](double x) {
    int low = 1, high = last;
    while (low < high) {
      const int middle = low + (high - low) / 2;
      if (grid.node_x(middle) >= x)
        high = middle;
      else
        low = middle + 1;
    }
    return low;
  };
  for (int row = 1; row < image.rows() - 1; ++row) {
    find_row(grid.node_y(row));
    for (std::size_t i = 0; i < row_.size(); i += 2) {
      const int end = i + 1 < row_.size() ? column_at(row_[i + 1]) : last;
      for (int column = column_at(row_[i]); column < end; ++column) image.set(column, row, true);
    }
  }
  return true;
}

std::size_t OutlineSection::crossings(double y) {
  find_row(y);
  return row_.size();
}

bool OutlineSection::contains(Vec2 p) {
  find_row(p.y);
  const auto right = std::upper_bound(row_.begin(), row_.end(), p.x);
  return (right - row_.begin()) % 2 != 0;
}

void OutlineSection::find_row(double y) {
  if (row_y_ == y) return;
  row_y_ = y;
  crossings_.clear();
  const auto add = [&](const OutlineSegment& s) {
    if (crosses(s, y)) crossings_.push_back({crossing_x(s, y), s.turn});
  };
  if (segments_.size() < kIndexedMin) {
    for (const OutlineSegment& s : segments_) add(s);
  } else {
    if (!indexed_) {
      std::vector<CoordinateRange> intervals;
      intervals.reserve(segments_.size());
      for (const OutlineSegment& s : segments_) intervals.push_back({s.low.y, s.high.y});
      by_y_ = IntervalIndex(intervals);
      indexed_ = true;
    }
    by_y_.for_each_near(y, [&](std::uint32_t i) { add(segments_[i]); });
  }
  find_changes();
}

// Crossings at one place count together, so that shells that touch have no void between them.
void OutlineSection::find_changes() {
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  row_.clear();
  int turns = turns_;
  bool inside = is_inside(turns);
  if (inside) row_.push_back(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    turns += counted(crossings_[i].turn);
    if (i + 1 < crossings_.size() && crossings_[i + 1].x == crossings_[i].x) continue;
    if (is_inside(turns) != inside) row_.push_back(crossings_[i].x);
    inside = is_inside(turns);
  }
}

}  // namespace slipstick
