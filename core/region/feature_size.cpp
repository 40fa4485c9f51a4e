#include "core/region/feature_size.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/image/sample.h"
#include "core/region/facing.h"
#include "core/region/image_chords.h"
#include "core/region/surface_probe.h"

namespace slipstick {
namespace {

// Finer than any nozzle; smaller solids are not sampled more finely.
constexpr double kStepMin = 0.005;
// Chords looked at before the next are compared with what was found.
constexpr std::size_t kBatch = 256;
// cos² of two degrees: normals are that good.
constexpr double kParallel = 0.99878;
// The sine of half the angle between sides that are near enough to parallel: 15 degrees together,
// where what fits between a plane and a cylinder seems a thirtieth smaller than it is.
constexpr double kInclined = 0.1305;
// But rows are up to half a step from the middle of a rod; there that sine is step / diameter. Some
// more, for its slant.
constexpr double kOffMiddle = 1.5;
// Sides that incline this much more along z than in the section are left to other sections.
constexpr double kOtherAxis = 1.25;

// x, y, z become y, z, x, so often.
Affine3 cycled(int times) {
  Affine3 map;
  std::rotate(map.rows.begin(), map.rows.begin() + times, map.rows.end());
  return map;
}

// Nothing between the ends of such a chord is smaller than this.
double least(const ImageChord& chord, double step) {
  return kAlongMin * step * (chord.nodes() - 1);
}

class Search {
 public:
  explicit Search(double step) : step_(step) {}

  // Looks at one section of `solid`. `back` leads from its frame to that of the answer.
  Result<void> look(const Solid& solid, const SliceGrid& grid, double z, const Affine3& back) {
    const auto section = solid.section(z);
    const auto image = sample(*section, grid);
    if (!image) return fail(image.error());
    ++found_.sections;
    const auto chords = chosen(chords_of(*image));
    if (chords.empty()) return {};
    SurfaceProbe probe(solid, z, step_);
    for (std::size_t i = 0; i < chords.size(); i += kBatch) {
      const auto batch = std::span(chords).subspan(i, std::min(kBatch, chords.size() - i));
      look_at(batch, grid, probe, back);
    }
    return {};
  }

  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] FeatureSizes take() {
    found_.step = step_;
    return found_;
  }

 private:
  std::optional<ThinPlace>& best(const ImageChord& chord) {
    return chord.inside ? found_.feature : found_.gap;
  }

  bool worth_it(const ImageChord& chord) {
    const auto& known = best(chord);
    return !known || least(chord, step_) < known->mm;
  }

  // The chords that can tell anything new, shortest first.
  std::vector<ImageChord> chosen(std::vector<ImageChord> chords) {
    std::erase_if(chords, [&](const ImageChord& chord) { return !worth_it(chord); });
    std::stable_sort(chords.begin(), chords.end(), [](const ImageChord& a, const ImageChord& b) {
      return a.nodes() < b.nodes();
    });
    if (chords.size() <= kFeatureChordsMax) return chords;
    std::vector<ImageChord> some;
    for (std::size_t i = 0; i < kFeatureChordsMax; ++i) {
      some.push_back(chords[i * chords.size() / kFeatureChordsMax]);
    }
    return some;
  }

  void look_at(std::span<const ImageChord> chords, const SliceGrid& grid, SurfaceProbe& probe,
               const Affine3& back) {
    std::vector<ImageChord> asked;
    std::vector<SurfaceBracket> ends;
    for (const ImageChord& chord : chords) {
      if (!worth_it(chord)) continue;
      asked.push_back(chord);
      ends.push_back(bracket(chord, grid, chord.begin, !chord.inside));
      ends.push_back(bracket(chord, grid, chord.end, chord.inside));
    }
    const auto points = probe.probe(ends);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const auto& first = points[2 * i];
      const auto& last = points[2 * i + 1];
      if (!first || !last) continue;
      const auto ball = ball_between({first->at, -1.0 * first->normal}, *last);
      auto& known = best(asked[i]);
      if (!ball || (known && ball->diameter >= known->mm)) continue;
      const bool parallel = ball->squared_cosine >= kParallel;
      if (!parallel && !holds(*ball, asked[i], *first, *last, probe)) continue;
      known = ThinPlace{ball->diameter, back(ball->centre)};
    }
  }

  // Whether a thickness between sides that are not parallel is one.
  bool holds(const BallBetween& ball, const ImageChord& chord, const SurfacePoint& first,
             const SurfacePoint& last, SurfaceProbe& probe) const {
    const double sine = std::max(kInclined, kOffMiddle * step_ / ball.diameter);
    if (1 - ball.squared_cosine > sine * sine) return false;
    const Vec3 a = first.normal, b = last.normal;
    const double upwards = std::abs(b.z / along(chord, b) - a.z / along(chord, a));
    const double across = std::abs(along(chord, {b.y, b.x, 0}) / along(chord, b) -
                                   along(chord, {a.y, a.x, 0}) / along(chord, a));
    // Sections along another axis see these chords and that way.
    if (upwards > kOtherAxis * across) return false;
    return !probe.is_wedge(chord.axis, first, last);
  }

  static double along(const ImageChord& chord, Vec3 v) {
    return chord.axis == SectionAxis::kX ? v.x : v.y;
  }

  // From the node before `node` to it.
  static SurfaceBracket bracket(const ImageChord& chord, const SliceGrid& grid, int node,
                                bool from_inside) {
    if (chord.axis == SectionAxis::kX) {
      return {chord.axis, grid.node_y(chord.line), grid.node_x(node - 1), grid.node_x(node),
              from_inside};
    }
    return {chord.axis, grid.node_x(chord.line), grid.node_y(node - 1), grid.node_y(node),
            from_inside};
  }

  double step_;
  FeatureSizes found_;
};

Result<void> look_along(Search& search, const Solid& solid, const Box3& box, int sections,
                        const Affine3& back) {
  const auto grid =
      SliceGrid::over({{box.low.x, box.low.y}, {box.high.x, box.high.y}}, search.step());
  if (!grid) return fail(grid.error());
  for (int i = 0; i < sections; ++i) {
    const double z = box.low.z + (i + 0.5) / sections * box.size().z;
    if (const auto looked = search.look(solid, *grid, z, back); !looked) return looked;
  }
  return {};
}

}  // namespace

std::optional<double> FeatureSizes::radius() const {
  if (!feature && !gap) return {};
  return std::min(feature ? feature->mm : gap->mm, gap ? gap->mm : feature->mm) / 2;
}

std::optional<double> FeatureSizes::sampling_limit() const {
  const auto r = radius();
  return r ? std::optional(*r / std::sqrt(3.0)) : std::nullopt;
}

Result<FeatureSizes> feature_sizes(const Model& model, const Affine3& map, const Box3& bounds,
                                   const FeatureSampling& sampling) {
  const Vec3 size = bounds.size();
  const double step = std::clamp(std::max({size.x, size.y, size.z}) / sampling.steps, kStepMin,
                                 SliceGrid::kWidthMax);
  Search search(step);
  for (int axis = 0; axis < 3; ++axis) {
    const Affine3 turn = cycled(axis);
    const auto solid = model.placed(composed(turn, map));
    const auto looked =
        look_along(search, *solid, image_of(turn, bounds), sampling.sections, inverse(turn));
    if (!looked) return fail(looked.error());
  }
  return search.take();
}

}  // namespace slipstick
