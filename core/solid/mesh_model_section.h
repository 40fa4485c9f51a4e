#pragma once

#include <memory>
#include <vector>

#include "core/solid/mesh_cut.h"
#include "core/solid/mesh_model_intervals.h"
#include "core/solid/solid.h"

namespace slipstick {

/// The inside of an outline. A segment crosses the rows low.y <= y < high.y.
class OutlineSection final : public Section {
 public:
  OutlineSection(std::vector<OutlineSegment> segments, Winding winding);

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override;
  [[nodiscard]] Narrowed narrowed(const Box2& box) override;
  void guess_changes(Vec2 from, Vec2 to, std::vector<double>& shares) override;
  /// Fills the runs between changes.
  bool paint(BitImage& image) override;

  /// How often the row at `y` changes between outside and inside.
  [[nodiscard]] std::size_t crossings(double y);

 private:
  struct Crossing {
    double x;
    int turn;
  };

  // Segments left out, which every point lies to the right of: what their turns add up to in rows
  // from `y` on.
  struct Step {
    double y;
    int turns;
  };

  [[nodiscard]] int turns_left_of(double y) const;
  void leave_out(const std::vector<OutlineSegment>& segments, const Box2& box);
  void find_changes(double y);
  void find_row(double y);
  [[nodiscard]] bool contains(Vec2 p);

  std::vector<OutlineSegment> segments_;
  Winding winding_;
  std::vector<Step> left_;  // by y; 0 below the first
  IntervalIndex by_y_;
  bool indexed_ = false;
  // The row asked last, its crossings, and where it goes in or out, in order.
  std::optional<double> row_y_;
  std::vector<Crossing> crossings_;
  std::vector<double> row_;
};

}  // namespace slipstick
