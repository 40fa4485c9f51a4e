#pragma once

#include <memory>
#include <vector>

#include "core/solid/mesh_model_intervals.h"
#include "core/solid/solid.h"

namespace slipstick {

/// A piece of a mesh's outline in a plane. \pre low.y < high.y.
struct OutlineSegment {
  Vec2 low;
  Vec2 high;
};

/// Whether every row crosses the outline an even number of times.
enum class Closedness : std::uint8_t { kOpen, kClosed };

/// The inside of an outline by parity: a point is inside if an odd number of crossings of the
/// outline with the point's row lies at or to the left of it. A segment crosses the rows low.y <= y
/// < high.y.
class OutlineSection final : public Section {
 public:
  OutlineSection(std::vector<OutlineSegment> segments, Closedness closedness);

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override;
  [[nodiscard]] Narrowed narrowed(const Box2& box) override;

  /// How often the row at `y` crosses the outline.
  [[nodiscard]] std::size_t crossings(double y);

 private:
  void find_row(double y);
  [[nodiscard]] bool contains(Vec2 p);

  std::vector<OutlineSegment> segments_;
  Closedness closedness_;
  IntervalIndex by_y_;
  bool indexed_ = false;
  // The row asked last, and where it crosses the outline, in order.
  std::optional<double> row_y_;
  std::vector<double> row_;
};

}  // namespace slipstick
