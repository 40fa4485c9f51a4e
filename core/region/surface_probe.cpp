#include "core/region/surface_probe.h"

#include <cmath>
#include <utility>

namespace slipstick {
namespace {

// Lines beside are this share of the step away. Small, so that rods of few steps are no edges;
// large against the places, which are found to 2^-10 of a step.
constexpr double kAsideShare = 0.125;
constexpr int kHalvings = 10;
// A surface steeper than this against the axis is another axis's to see.
constexpr double kSlopeMax = 2.5;
// Slopes before and behind may differ by this: less is the curve of a rod of 1.25 steps, more an
// edge.
constexpr double kBendMax = 0.1;
// How far away a wedge is to have grown, of its own thickness: a rod has its other side there.
constexpr double kThickerShare = 0.4;
// And how far away it is to be thinner: rows at a neck are at most half a step from its middle.
constexpr double kThinnerSteps = 2;

// Asks a section on which side many points are that lie on lines along its axes.
class Asker {
 public:
  explicit Asker(Section& section) : section_(section) {}

  void add(const SurfaceBracket& line, double at) {
    const bool along_x = line.axis == SectionAxis::kX;
    xs_.push_back(along_x ? at : line.line);
    ys_.push_back(along_x ? line.line : at);
  }

  [[nodiscard]] const std::vector<std::uint8_t>& ask() {
    inside_.resize(xs_.size());
    section_.classify(xs_, ys_, inside_);
    xs_.clear();
    ys_.clear();
    return inside_;
  }

 private:
  Section& section_;
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<std::uint8_t> inside_;
};

// Halves every bracket `kHalvings` times. \return their middles then.
std::vector<double> halved(Section& section, std::vector<SurfaceBracket> brackets) {
  Asker asker(section);
  const auto middle = [](const SurfaceBracket& b) { return b.from + (b.to - b.from) / 2; };
  for (int i = 0; i < kHalvings && !brackets.empty(); ++i) {
    for (const SurfaceBracket& b : brackets) asker.add(b, middle(b));
    const auto& inside = asker.ask();
    for (std::size_t k = 0; k < brackets.size(); ++k) {
      SurfaceBracket& b = brackets[k];
      ((inside[k] != 0) == b.from_inside ? b.from : b.to) = middle(b);
    }
  }
  std::vector<double> middles;
  middles.reserve(brackets.size());
  for (const SurfaceBracket& b : brackets) middles.push_back(middle(b));
  return middles;
}

// The slope of the surface between two lines; nothing where it bends.
std::optional<double> slope(std::optional<double> before, double at, std::optional<double> behind,
                            double aside) {
  if (!before || !behind) return {};
  const double first = (at - *before) / aside;
  const double second = (*behind - at) / aside;
  if (std::abs(second - first) > kBendMax) return {};
  return (first + second) / 2;
}

}  // namespace

SurfaceProbe::SurfaceProbe(const Solid& solid, double z, double step)
    : z_(z),
      step_(step),
      aside_(step * kAsideShare),
      below_(solid.section(z - aside_)),
      section_(solid.section(z)),
      above_(solid.section(z + aside_)) {}

// The same surface on lines moved by `aside`, looked for where its slope allows it.
SurfaceProbe::Places SurfaceProbe::beside(Section& section,
                                          std::span<const SurfaceBracket> brackets,
                                          const Places& places, double aside) {
  const double reach = kSlopeMax * aside_;
  Asker asker(section);
  std::vector<SurfaceBracket> near;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < brackets.size(); ++i) {
    if (!places[i]) continue;
    SurfaceBracket b = brackets[i];
    b.line += aside;
    b.from = *places[i] - reach;
    b.to = *places[i] + reach;
    asker.add(b, b.from);
    asker.add(b, b.to);
    near.push_back(b);
    which.push_back(i);
  }
  const auto& inside = asker.ask();
  std::vector<std::size_t> crossed;
  std::vector<SurfaceBracket> across;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const bool from = inside[2 * k] != 0, to = inside[2 * k + 1] != 0;
    if (from != near[k].from_inside || to == from) continue;
    crossed.push_back(which[k]);
    across.push_back(near[k]);
  }
  const auto found = halved(section, std::move(across));
  Places result(brackets.size());
  for (std::size_t k = 0; k < crossed.size(); ++k) result[crossed[k]] = found[k];
  return result;
}

std::vector<std::optional<SurfacePoint>> SurfaceProbe::probe(
    std::span<const SurfaceBracket> brackets) {
  const auto middles = halved(*section_, {brackets.begin(), brackets.end()});
  Places places(middles.begin(), middles.end());
  // What a step in this gives up, the others need not ask about.
  const auto slopes = [&](Section& before, Section& behind, double aside) {
    const Places first = beside(before, brackets, places, -aside);
    const Places last = beside(behind, brackets, places, aside);
    Places result(brackets.size());
    for (std::size_t i = 0; i < brackets.size(); ++i) {
      result[i] = slope(first[i], middles[i], last[i], aside_);
      if (!result[i]) places[i].reset();
    }
    return result;
  };
  const Places across = slopes(*section_, *section_, aside_);
  const Places upwards = slopes(*below_, *above_, 0);

  std::vector<std::optional<SurfacePoint>> points(brackets.size());
  for (std::size_t i = 0; i < brackets.size(); ++i) {
    if (!across[i] || !upwards[i]) continue;
    const double at = middles[i];
    const Vec3 along_x{1, -*across[i], -*upwards[i]};
    const double size = length(along_x);
    if (brackets[i].axis == SectionAxis::kX) {
      points[i] = {{at, brackets[i].line, z_}, (1 / size) * along_x};
    } else {
      points[i] = {{brackets[i].line, at, z_}, (1 / size) * Vec3{along_x.y, 1, along_x.z}};
    }
  }
  return points;
}

bool SurfaceProbe::is_wedge(SectionAxis axis, const SurfacePoint& first, const SurfacePoint& last) {
  const bool along_x = axis == SectionAxis::kX;
  const auto along = [&](Vec3 v) { return along_x ? v.x : v.y; };
  const auto across = [&](Vec3 v) { return along_x ? v.y : v.x; };
  const double a = -across(first.normal) / along(first.normal);
  const double b = -across(last.normal) / along(last.normal);
  const double lean = (a + b) / 2;
  const double growth = b - a;
  const double size = along(last.at - first.at);
  const SurfaceBracket line{axis, across(first.at)};
  Asker asker(*section_);
  // Half the growth there would be between straight sides: either they are beyond, or within.
  const auto add_ends = [&](double by) {
    SurfaceBracket moved = line;
    moved.line += by;
    asker.add(moved, along(first.at) + by * (lean - growth / 4));
    asker.add(moved, along(last.at) + by * (lean + growth / 4));
  };
  const double sign = growth < 0 ? -1 : 1;
  add_ends(sign * kThickerShare * size);
  add_ends(-sign * kThinnerSteps * step_);
  asker.add(line, (along(first.at) + along(last.at)) / 2);
  const auto& inside = asker.ask();
  const auto side = inside[4];
  return inside[0] == side && inside[1] == side && inside[2] != side && inside[3] != side;
}

}  // namespace slipstick
