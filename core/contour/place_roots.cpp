#include "core/contour/place_roots.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/contour/bracket.h"

namespace slipstick {
namespace {

// Neighbours along a contour are neighbours in space, so a batch asks a section narrowed to a small
// box. It ends where the box would be more than so many cells wide: at a loop that is far away.
constexpr std::size_t kBatch = 128;
// Without values each stick is asked for alone, so that a box of few sticks pays.
constexpr std::size_t kSmallBatch = 8;
// So many guesses are tried; then the stick is halved.
constexpr std::size_t kGuessesMax = 4;
constexpr auto kUnits = static_cast<std::int32_t>(SliceGrid::kUnitsPerCell);

// A stick in mm: exact, as all coordinates of the lattice are.
struct Rail {
  Vec2 inside;  // the node
  Vec2 unit;    // one 65536th of the way
};

class Roots {
 public:
  explicit Roots(ContourSet& contours) : contours_(contours) {}

  void run(Section& section) {
    const std::span<const Stick> sticks = std::as_const(contours_).sticks();
    for (std::size_t first = 0, count = 0; first < sticks.size(); first += count) {
      count = batch(sticks.subspan(first), kBatch);
      run(section, first, count);
    }
  }

 private:
  // How many of the first sticks, at most `most`, lie within a box of so many cells.
  static std::size_t batch(std::span<const Stick> sticks, std::size_t most) {
    const int extent = static_cast<int>(most);
    auto [left, low] = std::pair(sticks[0].column, sticks[0].row);
    auto [right, high] = std::pair(left, low);
    std::size_t count = 1;
    for (; count < std::min(most, sticks.size()); ++count) {
      const Stick& s = sticks[count];
      left = std::min(left, s.column);
      right = std::max(right, s.column);
      low = std::min(low, s.row);
      high = std::max(high, s.row);
      if (right - left > extent || high - low > extent) break;
    }
    return count;
  }

  void run(Section& section, std::size_t first, std::size_t count) {
    const auto sticks = contours_.sticks().subspan(first, count);
    const Section::Narrowed narrowed = section.narrowed(box_around(sticks));
    Section& inner = narrowed.section ? *narrowed.section : section;
    const auto places = contours_.places().subspan(first, count);
    if (by_values(inner, sticks, places)) return;
    for (std::size_t i = 0, few = 0; i < count; i += few) {
      few = batch(sticks.subspan(i), kSmallBatch);
      by_membership(inner, sticks.subspan(i, few), places.subspan(i, few));
    }
  }

  Box2 box_around(std::span<const Stick> sticks) const {
    Box2 box;
    for (const Stick& stick : sticks) {
      box = box.with(mm(along(stick, 0))).with(mm(along(stick, kUnits)));
    }
    return box;
  }

  bool by_values(Section& section, std::span<const Stick> sticks, std::span<Place> places) {
    const std::size_t count = sticks.size();
    rails_.clear();
    for (const Stick& stick : sticks) rails_.push_back(rail_of(stick));
    xs_.resize(count);
    ys_.resize(count);
    values_.resize(2 * count);
    const std::span<double> inside = std::span(values_).first(count);
    const std::span<double> outside = std::span(values_).last(count);
    for (std::size_t i = 0; i < count; ++i) put(i, rails_[i], 0);
    if (!section.evaluate(xs_, ys_, inside)) return false;
    for (std::size_t i = 0; i < count; ++i) put(i, rails_[i], kUnits);
    section.evaluate(xs_, ys_, outside);
    brackets_.clear();
    open_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      brackets_.emplace_back(inside[i], outside[i]);
      open_.push_back(i);
    }
    while (!open_.empty()) narrow(section, places);
    return true;
  }

  // One more value for every bracket that is open.
  void narrow(Section& section, std::span<Place> places) {
    const std::size_t count = open_.size();
    for (std::size_t i = 0; i < count; ++i) {
      put(i, rails_[open_[i]], brackets_[open_[i]].next());
    }
    section.evaluate(std::span(xs_).first(count), std::span(ys_).first(count),
                     std::span(values_).first(count));
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t stick = open_[i];
      Bracket& bracket = brackets_[stick];
      bracket.take(values_[i]);
      if (bracket.closed()) {
        places[stick] = Place::clamped(bracket.inside());
      } else {
        open_[left++] = stick;
      }
    }
    open_.resize(left);
  }

  void by_membership(Section& outer, std::span<const Stick> sticks, std::span<Place> places) {
    const Section::Narrowed narrowed = outer.narrowed(box_around(sticks));
    Section& section = narrowed.section ? *narrowed.section : outer;
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      const auto guessed = by_guess(section, sticks[i]);
      places[i] = Place::clamped(guessed ? *guessed : by_halving(section, sticks[i]));
    }
  }

  // The inside end of a change that the section knew of.
  std::optional<std::int32_t> by_guess(Section& section, Stick stick) {
    section.guess_changes(mm(along(stick, 0)), mm(along(stick, kUnits)), shares_);
    const std::size_t tries = std::min(shares_.size(), kGuessesMax);
    for (std::size_t i = 0; i < tries; ++i) {
      const double at = std::clamp(shares_[i] * kUnits, 0.0, kUnits - 1.0);
      const auto k = static_cast<std::int32_t>(at);
      const bool here = contains(section, stick, k);
      const std::int32_t inside = here ? k : k - 1;
      if (here != contains(section, stick, here ? k + 1 : k - 1)) return inside;
      // Rounding may have put it one further on.
      if (here && k + 2 <= kUnits && !contains(section, stick, k + 2)) return k + 1;
    }
    return {};
  }

  std::int32_t by_halving(Section& section, Stick stick) {
    std::int32_t inside = 0;  // the other end of the bracket is 2·half farther
    for (std::int32_t half = kUnits / 2; half > 0; half /= 2) {
      if (contains(section, stick, inside + half)) inside += half;
    }
    return inside;
  }

  // The ends are known.
  bool contains(Section& section, Stick stick, std::int32_t k) {
    if (k <= 0 || k >= kUnits) return k <= 0;
    const Vec2 p = mm(along(stick, k));
    std::uint8_t inside = 0;
    section.classify({&p.x, 1}, {&p.y, 1}, {&inside, 1});
    return inside != 0;
  }

  void put(std::size_t i, const Rail& rail, std::int32_t k) {
    xs_[i] = rail.inside.x + rail.unit.x * k;
    ys_[i] = rail.inside.y + rail.unit.y * k;
  }

  Rail rail_of(Stick stick) const {
    const Step e = step(stick.outward);
    const double unit = contours_.grid().unit();
    return {mm(inside_node(stick)), {unit * e.x, unit * e.y}};
  }

  Vec2 mm(GridPoint p) const { return {contours_.grid().x_of(p.x), contours_.grid().y_of(p.y)}; }

  ContourSet& contours_;
  std::vector<Rail> rails_;  // of the batch
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<double> values_;
  std::vector<Bracket> brackets_;  // of the batch
  std::vector<std::size_t> open_;  // those that are not closed
  std::vector<double> shares_;
};

}  // namespace

void place_roots(ContourSet& contours, Section& section) {
  Roots(contours).run(section);
}

}  // namespace slipstick
