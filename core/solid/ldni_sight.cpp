#include "core/solid/ldni_sight.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace slipstick {
namespace {

constexpr double kPerUnit = 1.0 / LdniGrid::kUnits;

double widths(std::uint32_t depth) {
  return depth * kPerUnit;
}

constexpr double kFar = kLdniShiftMax + kLdniReach;

// A place along rays, and the depths between which samples may matter there.
struct Place {
  explicit Place(double widths_along)
      : at(widths_along), from(units(at - kFar)), end(units(at + kFar)) {}

  static std::uint32_t units(double widths_along) {
    return static_cast<std::uint32_t>(
        std::clamp(widths_along * LdniGrid::kUnits, 0.0, 4294967295.0));
  }

  double at;
  std::uint32_t from;
  std::uint32_t end;
};

// How far a point is from a ray across it.
struct Across {
  double i;
  double j;
};

struct Opinion {
  double weight = 0;  // 0: no sample has a say
  double value = 0;
  bool inside = false;
};

// How much farther the tangent plane of a sample passes a line beside its ray.
double shift(const LdniNormal& normal, std::size_t axis, const Across& across) {
  const double along = normal.along(axis);
  const double slope =
      normal.along((axis + 1) % 3) * across.i + normal.along((axis + 2) % 3) * across.j;
  return along == 0 ? 0 : std::clamp(-slope / along, -kLdniShiftMax, kLdniShiftMax);
}

// The most that a sample is moved by, and a little for rounding.
double shift_most(const LdniNormal& normal, std::size_t axis) {
  constexpr double kRounding = 1e-9;
  const double along = std::abs(normal.along(axis));
  const double across =
      std::abs(normal.along((axis + 1) % 3)) + std::abs(normal.along((axis + 2) % 3));
  return std::min(along * kLdniShiftMax < across ? kLdniShiftMax : across / along, kLdniShiftMax) +
         kRounding;
}

// From 1 to 0 as the share goes from 0 to 1.
double fading(double share) {
  return (1 - share * share) * (1 - share * share);
}

// Between the normal and its ray.
double cosine(const LdniNormal& n, std::size_t axis) {
  const int all = n.along(0) * n.along(0) + n.along(1) * n.along(1) + n.along(2) * n.along(2);
  return std::abs(n.along(axis)) / std::sqrt(static_cast<double>(all));
}

// The nearest sample so far.
struct Nearest {
  double distance = kLdniReach;
  double shift = 0;
  const LdniSample* sample = nullptr;

  void consider(const LdniSample& s, double moved_by, double at) {
    const double off = std::abs(widths(s.depth) + moved_by - at);
    if (off < distance) *this = {off, moved_by, &s};
  }
};

// The first pair of samples, in and out, that is not all behind what may matter.
std::size_t first_pair(std::span<const LdniSample> ray, std::uint32_t from) {
  constexpr std::size_t kFew = 16;
  if (ray.size() > kFew) {
    const auto first =
        std::ranges::partition_point(ray, [&](const LdniSample& s) { return s.depth < from; });
    return static_cast<std::size_t>(first - ray.begin()) / 2 * 2;
  }
  std::size_t k = 0;
  while (k < ray.size() && ray[k + 1].depth < from) k += 2;
  return k;
}

// Pairs count one by one: where planes that bound an edge meet, the pair is empty beyond.
Opinion opinion(std::span<const LdniSample> ray, std::size_t axis, const Place& place,
                const Across& across) {
  Opinion opinion;
  Nearest nearest;
  for (std::size_t k = first_pair(ray, place.from); k < ray.size(); k += 2) {
    const LdniSample &in = ray[k], &out = ray[k + 1];
    if (in.depth > place.end) break;
    bool inside = true;
    if (in.depth >= place.from) {
      const double by = shift(in.normal, axis, across);
      nearest.consider(in, by, place.at);
      inside = widths(in.depth) + by <= place.at;
    }
    if (out.depth <= place.end) {
      const double by = shift(out.normal, axis, across);
      nearest.consider(out, by, place.at);
      inside = inside && place.at <= widths(out.depth) + by;
    }
    opinion.inside = opinion.inside || inside;
  }
  if (nearest.sample == nullptr) return opinion;
  const double square = cosine(nearest.sample->normal, axis);
  opinion.weight = square * square * square * square * fading(nearest.distance / kLdniReach) *
                   fading(nearest.shift / kLdniShiftMax);
  opinion.value = (opinion.inside ? -1 : 1) * nearest.distance * square;
  return opinion;
}

// Whether a ray is inside, or outside, of all places from `low` to `high`, whatever its samples are
// moved by.
Cover cover_along(std::span<const LdniSample> ray, std::size_t axis, double low, double high) {
  Cover cover = Cover::kOutside;
  const std::uint32_t from = Place(low).from, end = Place(high).end;
  for (std::size_t k = first_pair(ray, from); k < ray.size() && ray[k].depth <= end; k += 2) {
    const double in = widths(ray[k].depth), out = widths(ray[k + 1].depth);
    const double in_off = shift_most(ray[k].normal, axis);
    const double out_off = shift_most(ray[k + 1].normal, axis);
    if (in - in_off > high || out + out_off < low) continue;
    if (in + in_off > low || out - out_off < high) return Cover::kMixed;
    cover = Cover::kInside;
  }
  return cover;
}

}  // namespace

void LdniSight::add_axis(const LdniPoint& p, std::size_t axis, Sum& sum) const {
  const LdniGrid& grid = ldni_.grid();
  const LdniRays& rays = ldni_.axes()[axis];
  const double u = p[(axis + 1) % 3], v = p[(axis + 2) % 3];
  const int last = grid.resolution() - 2;
  const Place place(p[axis]);
  const int i = std::min(static_cast<int>(u), last), j = std::min(static_cast<int>(v), last);
  for (int dj = 0; dj < 2; ++dj) {
    for (int di = 0; di < 2; ++di) {
      const double across_i = u - (i + di), across_j = v - (j + dj);
      const double near = (1 - std::abs(across_i)) * (1 - std::abs(across_j));
      if (!(near > 0)) continue;
      const Opinion said =
          opinion(rays.of(grid.ray(i + di, j + dj)), axis, place, {across_i, across_j});
      sum.votes += said.inside ? -near : near;
      sum.weights += near * said.weight;
      sum.values += near * said.weight * said.value;
    }
  }
}

Cover LdniSight::cover(const LdniPoint& low, const LdniPoint& high) const {
  const LdniGrid& grid = ldni_.grid();
  const int last = grid.resolution() - 1;
  for (std::size_t k = 0; k < low.size(); ++k) {
    if (!(low[k] >= 0 && high[k] <= last)) return Cover::kMixed;
  }
  const auto first_line = [&](std::size_t k) { return static_cast<int>(low[k]); };
  const auto last_line = [&](std::size_t k) {
    return std::min(static_cast<int>(high[k]) + 1, last);
  };
  std::optional<Cover> all;
  for (std::size_t axis = 0; axis < low.size(); ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int j = first_line(v); j <= last_line(v); ++j) {
      for (int i = first_line(u); i <= last_line(u); ++i) {
        const Cover here =
            cover_along(ldni_.axes()[axis].of(grid.ray(i, j)), axis, low[axis], high[axis]);
        if (here == Cover::kMixed || here != all.value_or(here)) return Cover::kMixed;
        all = here;
      }
    }
  }
  return *all;
}

double LdniSight::value(const LdniPoint& p) const {
  constexpr double kAxes = 3;
  constexpr double kVotesWeigh = 0.01;  // near a surface samples weigh from 1/3 to 1
  const double end = ldni_.grid().resolution() - 1;
  for (const double c : p) {
    if (!(c >= 0 && c <= end)) return 1;
  }
  Sum sum;
  for (std::size_t axis = 0; axis < p.size(); ++axis) add_axis(p, axis, sum);
  return (sum.values + kVotesWeigh * sum.votes / kAxes) / (sum.weights + kVotesWeigh);
}

}  // namespace slipstick
