#include "core/solid/mesh_model_section.h"

#include <algorithm>

#include "core/base/check.h"

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

OutlineSection::OutlineSection(std::vector<OutlineSegment> segments, Closedness closedness)
    : segments_(std::move(segments)), closedness_(closedness) {}

void OutlineSection::classify(std::span<const double> xs, std::span<const double> ys,
                              std::span<std::uint8_t> inside) {
  SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == inside.size());
  for (std::size_t i = 0; i < xs.size(); ++i) {
    inside[i] = contains({xs[i], ys[i]}) ? std::uint8_t{1} : std::uint8_t{0};
  }
}

// Segments above, below and to the right of the box never count in it and are dropped. If none of
// the others touches it, a closed outline passes it on the left as a whole, so that all its points
// have one answer; an open one may end there.
Section::Narrowed OutlineSection::narrowed(const Box2& box) {
  std::vector<OutlineSegment> kept;
  bool touched = false;
  for (const OutlineSegment& s : segments_) {
    if (s.high.y <= box.low.y || s.low.y > box.high.y) continue;
    if (std::min(s.low.x, s.high.x) > box.high.x) continue;
    kept.push_back(s);
    touched = touched || std::max(s.low.x, s.high.x) >= box.low.x;
  }
  if (kept.empty()) return {Cover::kOutside, nullptr};
  if (!touched && closedness_ == Closedness::kClosed) {
    return {contains(box.low) ? Cover::kInside : Cover::kOutside, nullptr};
  }
  return {Cover::kMixed, std::make_unique<OutlineSection>(std::move(kept), closedness_)};
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
  row_.clear();
  const auto add = [&](const OutlineSegment& s) {
    if (crosses(s, y)) row_.push_back(crossing_x(s, y));
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
  std::sort(row_.begin(), row_.end());
}

}  // namespace slipstick
