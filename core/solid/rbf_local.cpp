#include "core/solid/rbf_local.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {
namespace {

constexpr std::size_t kTerms = 6;  // 1, u, v, uu, uv, vv
using Terms = std::array<double, kTerms>;

// Points that a support holds at least; some more than a quadratic needs.
constexpr std::size_t kPointsMin = 10;
constexpr double kStep = 1.2;
constexpr int kStepsMax = 24;
// A support never reaches across the model.
constexpr double kRadiusShareMax = 0.15;
// Relative to the diagonal: keeps a fit to points on a line or in a plane solvable.
constexpr double kRidge = 1e-10;

// Points whose normals are within 60 degrees of the centre's are of its sheet. Others, beyond a
// sharp edge or on the other side of a wall, are not fitted but count as so far off, in radii.
constexpr double kSameSheet = 0.5;
constexpr double kStranger = 0.1;

// Fewer points than this tell a plane and no more: curvature then costs as much as being off. The
// little that it always costs keeps a quadric from bending where no point holds it.
constexpr std::size_t kBendingMin = 9;
constexpr double kStiff = 1;
constexpr double kSupple = 1e-4;

struct Frame {
  Vec3 u;
  Vec3 v;
  Vec3 w;
};

Frame frame_of(Vec3 w) {
  const Vec3 size{std::abs(w.x), std::abs(w.y), std::abs(w.z)};
  const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                    : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                         : Vec3{0, 0, 1};
  const Vec3 across = cross(w, axis);
  const Vec3 u = (1 / length(across)) * across;
  return {u, cross(w, u), w};
}

// Points in the frame, in units of the radius.
struct Sample {
  Vec3 at;
  double weight;
};

Terms terms_at(Vec3 p) {
  return {1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y};
}

double height(const Terms& h, Vec3 p) {
  const Terms t = terms_at(p);
  double sum = 0;
  for (std::size_t i = 0; i < kTerms; ++i) sum += h[i] * t[i];
  return sum;
}

struct NormalEquations {
  std::array<Terms, kTerms> matrix{};
  Terms right{};

  void add(const Sample& s) {
    const Terms t = terms_at(s.at);
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t j = 0; j <= i; ++j) matrix[i][j] += s.weight * (t[i] * t[j]);
      right[i] += s.weight * (t[i] * s.at.z);
    }
  }

  // Cholesky. Positive definite by the ridge.
  [[nodiscard]] Terms solved() {
    double trace = 0;
    for (std::size_t i = 0; i < kTerms; ++i) trace += matrix[i][i];
    for (std::size_t i = 0; i < kTerms; ++i) matrix[i][i] += kRidge * trace;
    for (std::size_t i = 0; i < kTerms; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) matrix[i][j] -= matrix[i][k] * matrix[j][k];
        matrix[i][j] /= matrix[j][j];
        matrix[i][i] -= matrix[i][j] * matrix[i][j];
        right[i] -= matrix[i][j] * right[j];
      }
      matrix[i][i] = std::sqrt(std::max(matrix[i][i], kRidge * kRidge * trace));
      right[i] /= matrix[i][i];
    }
    for (std::size_t i = kTerms; i-- > 0;) {
      for (std::size_t k = i + 1; k < kTerms; ++k) right[i] -= matrix[k][i] * right[k];
      right[i] /= matrix[i][i];
    }
    return right;
  }
};

// w - h(u, v) with u, v, w in units of `radius`, as a quadric in space.
RbfFunction::Quadric quadric_of(const Terms& h, const Frame& f, double radius) {
  const double uu = h[3] / radius, uv = h[4] / radius, vv = h[5] / radius;
  const Vec3 linear = f.w - h[1] * f.u - h[2] * f.v;
  const auto square = [&](double u, double v) { return -(uu * u * u + uv * u * v + vv * v * v); };
  const auto mixed = [&](double u1, double v1, double u2, double v2) {
    return -(2 * uu * u1 * u2 + uv * (u1 * v2 + u2 * v1) + 2 * vv * v1 * v2);
  };
  return {-h[0] * radius,
          linear.x,
          linear.y,
          linear.z,
          square(f.u.x, f.v.x),
          square(f.u.y, f.v.y),
          square(f.u.z, f.v.z),
          mixed(f.u.x, f.v.x, f.u.y, f.v.y),
          mixed(f.u.y, f.v.y, f.u.z, f.v.z),
          mixed(f.u.z, f.v.z, f.u.x, f.v.x)};
}

Terms solved(std::span<const Sample> samples) {
  NormalEquations equations;
  for (const Sample& s : samples) equations.add(s);
  // The first term sums the weights.
  const double stiffness = samples.size() < kBendingMin ? kStiff : kSupple;
  for (std::size_t i = 3; i < kTerms; ++i) {
    equations.matrix[i][i] += stiffness * equations.matrix[0][0];
  }
  return equations.solved();
}

}  // namespace

std::optional<LocalFit> fit_local(const PointCloud& cloud, const PointIndex& index,
                                  std::uint32_t centre, double radius) {
  struct Near {
    std::uint32_t index;
    double weight;
  };
  std::vector<Near> near;
  Vec3 mean;
  double weights = 0, strangers = 0;
  const Vec3 c = cloud.points[centre];
  index.for_each_within(c, radius, [&](std::uint32_t i, double square) {
    const double weight = wendland(square, radius);
    if (dot(cloud.normals[i], cloud.normals[centre]) < kSameSheet) {
      strangers += weight;
      return;
    }
    near.push_back({i, weight});
    mean = mean + weight * cloud.normals[i];
    weights += weight;
  });
  if (!(length(mean) > 0)) return {};
  const Frame frame = frame_of((1 / length(mean)) * mean);
  std::vector<Sample> samples;
  samples.reserve(near.size());
  for (const Near& n : near) {
    const Vec3 d = (1 / radius) * (cloud.points[n.index] - c);
    samples.push_back({{dot(d, frame.u), dot(d, frame.v), dot(d, frame.w)}, n.weight});
  }
  const Terms h = solved(samples);
  double squares = kStranger * kStranger * strangers;
  for (const Sample& s : samples) {
    const double off = s.at.z - height(h, s.at);
    squares += s.weight * (off * off);
  }
  const double mean_square = squares / (weights + strangers) * radius * radius;
  return LocalFit{{c, radius, quadric_of(h, frame, radius)}, mean_square};
}

LocalFit fit_adaptive(const PointCloud& cloud, const PointIndex& index, std::uint32_t centre,
                      double tolerance) {
  const Vec3 c = cloud.points[centre];
  const double diagonal = length(index.box().size());
  const double largest = kRadiusShareMax * diagonal;
  const double nearest = index.reach_of(c, std::min(kPointsMin, cloud.points.size()));
  double radius = std::max(1.05 * nearest, 1e-6 * diagonal);
  // What remains if nothing can be fitted: the tangent plane.
  const Vec3 n = cloud.normals[centre];
  LocalFit best{{c, radius, {0, n.x, n.y, n.z, 0, 0, 0, 0, 0, 0}}, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kStepsMax && (step == 0 || radius <= largest); ++step) {
    const auto fit = fit_local(cloud, index, centre, radius);
    if (!fit) break;
    const double error = fit->mean_square / (diagonal * diagonal);
    const double share = tolerance * diagonal / radius;
    if (error > least) break;  // error grows with the radius: no larger one can win
    if (error + share * share < least) {
      least = error + share * share;
      best = *fit;
    }
    radius *= kStep;
  }
  return best;
}

}  // namespace slipstick
