#include "core/contour/place_roots.h"

#include <algorithm>
#include <vector>

#include "core/contour/bracket.h"

namespace slipstick {
namespace {

// Neighbours along a contour are neighbours in space, so a batch asks a section narrowed to a small
// box.
constexpr std::size_t kBatch = 128;
// Bisection asks so often that a box of so few sticks pays.
constexpr std::size_t kSmallBatch = 8;

class Roots {
 public:
  explicit Roots(ContourSet& contours) : contours_(contours) {}

  void run(Section& section, std::size_t first, std::size_t count) {
    const auto sticks = contours_.sticks().subspan(first, count);
    const Section::Narrowed narrowed = section.narrowed(box_around(sticks));
    Section& inner = narrowed.section ? *narrowed.section : section;
    const auto places = contours_.places().subspan(first, count);
    if (by_values(inner, sticks, places)) return;
    for (std::size_t i = 0; i < count; i += kSmallBatch) {
      const std::size_t few = std::min(kSmallBatch, count - i);
      by_bisection(inner, sticks.subspan(i, few), places.subspan(i, few));
    }
  }

 private:
  Box2 box_around(std::span<const Stick> sticks) const {
    Box2 box;
    for (const Stick& stick : sticks) {
      box = box.with(mm(along(stick, 0))).with(mm(along(stick, SliceGrid::kUnitsPerCell)));
    }
    return box;
  }

  bool by_values(Section& section, std::span<const Stick> sticks, std::span<Place> places) {
    const std::size_t count = sticks.size();
    xs_.resize(count);
    ys_.resize(count);
    values_.resize(2 * count);
    const std::span<double> inside = std::span(values_).first(count);
    const std::span<double> outside = std::span(values_).last(count);
    for (std::size_t i = 0; i < count; ++i) put(i, sticks[i], 0);
    if (!section.evaluate(xs_, ys_, inside)) return false;
    for (std::size_t i = 0; i < count; ++i) put(i, sticks[i], SliceGrid::kUnitsPerCell);
    section.evaluate(xs_, ys_, outside);
    open_.clear();
    for (std::size_t i = 0; i < count; ++i) open_.push_back({i, Bracket(inside[i], outside[i])});
    while (!open_.empty()) narrow(section, sticks, places);
    return true;
  }

  // One more value for every bracket that is open.
  void narrow(Section& section, std::span<const Stick> sticks, std::span<Place> places) {
    const std::size_t count = open_.size();
    for (std::size_t i = 0; i < count; ++i) {
      put(i, sticks[open_[i].stick], open_[i].bracket.next());
    }
    section.evaluate(std::span(xs_).first(count), std::span(ys_).first(count),
                     std::span(values_).first(count));
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Open& open = open_[i];
      open.bracket.take(values_[i]);
      if (open.bracket.closed()) {
        places[open.stick] = Place::clamped(open.bracket.inside());
      } else {
        open_[left++] = open;
      }
    }
    open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(left), open_.end());
  }

  void by_bisection(Section& outer, std::span<const Stick> sticks, std::span<Place> places) {
    const Section::Narrowed narrowed = outer.narrowed(box_around(sticks));
    Section& section = narrowed.section ? *narrowed.section : outer;
    xs_.resize(sticks.size());
    ys_.resize(sticks.size());
    inside_end_.assign(sticks.size(), 0);
    inside_.resize(sticks.size());
    for (std::int32_t half = SliceGrid::kUnitsPerCell / 2; half > 0; half /= 2) {
      for (std::size_t i = 0; i < sticks.size(); ++i) put(i, sticks[i], inside_end_[i] + half);
      section.classify(xs_, ys_, inside_);
      for (std::size_t i = 0; i < sticks.size(); ++i) {
        if (inside_[i] != 0) inside_end_[i] += half;
      }
    }
    std::transform(inside_end_.begin(), inside_end_.end(), places.begin(), &Place::clamped);
  }

  void put(std::size_t i, Stick stick, std::int32_t k) {
    const Vec2 p = mm(along(stick, k));
    xs_[i] = p.x;
    ys_[i] = p.y;
  }

  Vec2 mm(GridPoint p) const { return {contours_.grid().x_of(p.x), contours_.grid().y_of(p.y)}; }

  struct Open {
    std::size_t stick = 0;
    Bracket bracket;
  };

  ContourSet& contours_;
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<double> values_;
  std::vector<Open> open_;
  // The bracket's inside end; its other end is half a stick, then a quarter, … farther.
  std::vector<std::int32_t> inside_end_;
  std::vector<std::uint8_t> inside_;
};

}  // namespace

void place_roots(ContourSet& contours, Section& section) {
  Roots roots(contours);
  const std::size_t count = contours.sticks().size();
  for (std::size_t first = 0; first < count; first += kBatch) {
    roots.run(section, first, std::min(kBatch, count - first));
  }
}

}  // namespace slipstick
