#include "core/solid/mesh_model_section.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/base/check.h"
#include "core/image/bit_image.h"

namespace slipstick {
namespace {

// Sections of fewer segments are searched one by one.
constexpr std::size_t kIndexedMin = 32;

bool crosses(const OutlineSegment& s, double y) {
  return s.low.y <= y && y < s.high.y;
}

}  // namespace

OutlineSection::OutlineSection(std::vector<OutlineSegment> segments, Winding winding)
    : segments_(std::move(segments)), winding_(winding) {}

void OutlineSection::classify(std::span<const double> xs, std::span<const double> ys,
                              std::span<std::uint8_t> inside) {
  SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == inside.size());
  for (std::size_t i = 0; i < xs.size(); ++i) {
    inside[i] = contains({xs[i], ys[i]}) ? std::uint8_t{1} : std::uint8_t{0};
  }
}

// Where the way meets segments, whether they change anything or not.
void OutlineSection::guess_changes(Vec2 from, Vec2 to, std::vector<double>& shares) {
  shares.clear();
  const bool along_x = from.y == to.y;
  const double begin = along_x ? from.x : from.y, end = along_x ? to.x : to.y;
  const double low = std::min(begin, end), high = std::max(begin, end);
  const auto add = [&](double at) {
    if (at >= low && at <= high) shares.push_back((at - begin) / (end - begin));
  };
  if (along_x) {
    find_row(from.y);
    for (const double x : row_) add(x);
    return;
  }
  for (const OutlineSegment& s : segments_) {
    if (s.high.y < low || s.low.y > high) continue;
    if ((s.low.x <= from.x) == (s.high.x <= from.x)) continue;
    add(s.low.y + (from.x - s.low.x) / (s.high.x - s.low.x) * (s.high.y - s.low.y));
  }
  for (const Step& step : left_) add(step.y);
}

// Segments above, below and to the right of the box never count in it and are dropped; of those on
// its left only the turns are kept. Where those are the same in all rows and no segment reaches the
// box, all its points have one answer; a level edge is no segment, but a change from row to row.
Section::Narrowed OutlineSection::narrowed(const Box2& box) {
  std::vector<OutlineSegment> near, on_the_left;
  for (const OutlineSegment& s : segments_) {
    if (s.high.y <= box.low.y || s.low.y > box.high.y) continue;
    if (std::min(s.low.x, s.high.x) > box.high.x) continue;
    (std::max(s.low.x, s.high.x) < box.low.x ? on_the_left : near).push_back(s);
  }
  const bool none = near.empty();
  auto inner = std::make_unique<OutlineSection>(std::move(near), winding_);
  inner->left_ = left_;
  inner->leave_out(on_the_left, box);
  const bool inside = is_inside(winding_, inner->turns_left_of(box.low.y));
  const auto is_same = [&](const Step& step) { return is_inside(winding_, step.turns) == inside; };
  if (none && std::all_of(inner->left_.begin(), inner->left_.end(), is_same)) {
    return {inside ? Cover::kInside : Cover::kOutside, nullptr};
  }
  return {Cover::kMixed, std::move(inner)};
}

// Adds the turns of `segments` to those left out already, for the rows of `box`. Along a chain one
// segment begins where another ends, so that only its ends and turning points remain.
void OutlineSection::leave_out(const std::vector<OutlineSegment>& segments, const Box2& box) {
  std::vector<Step> changes;
  const auto change = [&](double y, int turns) {
    if (y <= box.high.y) changes.push_back({std::max(y, box.low.y), turns});
  };
  int before = 0;
  for (const Step& step : left_) change(step.y, step.turns - std::exchange(before, step.turns));
  for (const OutlineSegment& s : segments) {
    change(s.low.y, counted(winding_, s.turn));
    change(s.high.y, -counted(winding_, s.turn));
  }
  std::sort(changes.begin(), changes.end(), [](const Step& a, const Step& b) { return a.y < b.y; });
  left_.clear();
  int turns = 0;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    turns += changes[i].turns;
    if (i + 1 < changes.size() && changes[i + 1].y == changes[i].y) continue;
    if (left_.empty() || turns != left_.back().turns) left_.push_back({changes[i].y, turns});
  }
}

int OutlineSection::turns_left_of(double y) const {
  const auto next = std::upper_bound(left_.begin(), left_.end(), y,
                                     [](double at, const Step& step) { return at < step.y; });
  return next == left_.begin() ? 0 : std::prev(next)->turns;
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
  find_changes(y);
}

// Crossings at one place count together, so that shells that touch have no void between them.
void OutlineSection::find_changes(double y) {
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  row_.clear();
  int turns = turns_left_of(y);
  bool inside = is_inside(winding_, turns);
  if (inside) row_.push_back(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    turns += counted(winding_, crossings_[i].turn);
    if (i + 1 < crossings_.size() && crossings_[i + 1].x == crossings_[i].x) continue;
    if (is_inside(winding_, turns) != inside) row_.push_back(crossings_[i].x);
    inside = is_inside(winding_, turns);
  }
}

}  // namespace slipstick
