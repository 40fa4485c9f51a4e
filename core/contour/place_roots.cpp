#include "core/contour/place_roots.h"

#include <algorithm>
#include <vector>

namespace slipstick {
namespace {

// Neighbours along a contour are neighbours in space, so a batch asks a section narrowed to a small
// box.
constexpr std::size_t kBatch = 64;

class Bisection {
 public:
  explicit Bisection(ContourSet& contours) : contours_(contours) {}

  void run(Section& section, std::size_t first, std::size_t count) {
    const auto sticks = contours_.sticks().subspan(first, count);
    const Section::Narrowed narrowed = section.narrowed(box_around(sticks));
    Section& inner = narrowed.section ? *narrowed.section : section;
    inside_end_.assign(count, 0);
    xs_.resize(count);
    ys_.resize(count);
    inside_.resize(count);
    for (std::int32_t half = SliceGrid::kUnitsPerCell / 2; half > 0; half /= 2) {
      halve(inner, sticks, half);
    }
    const auto places = contours_.places().subspan(first, count);
    std::transform(inside_end_.begin(), inside_end_.end(), places.begin(), &Place::clamped);
  }

 private:
  Box2 box_around(std::span<const Stick> sticks) const {
    Box2 box;
    for (const Stick& stick : sticks) {
      box = box.with(mm(along(stick, 0))).with(mm(along(stick, SliceGrid::kUnitsPerCell)));
    }
    return box;
  }

  void halve(Section& section, std::span<const Stick> sticks, std::int32_t half) {
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      const Vec2 p = mm(along(sticks[i], inside_end_[i] + half));
      xs_[i] = p.x;
      ys_[i] = p.y;
    }
    section.classify(xs_, ys_, inside_);
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      if (inside_[i] != 0) inside_end_[i] += half;
    }
  }

  Vec2 mm(GridPoint p) const { return {contours_.grid().x_of(p.x), contours_.grid().y_of(p.y)}; }

  ContourSet& contours_;
  std::vector<std::int32_t>
      inside_end_;  // the bracket's inside end; its other end is `half` farther
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<std::uint8_t> inside_;
};

}  // namespace

void place_roots(ContourSet& contours, Section& section) {
  Bisection bisection(contours);
  const std::size_t count = contours.sticks().size();
  for (std::size_t first = 0; first < count; first += kBatch) {
    bisection.run(section, first, std::min(kBatch, count - first));
  }
}

}  // namespace slipstick
