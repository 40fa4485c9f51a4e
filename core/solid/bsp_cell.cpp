#include "core/solid/bsp_cell.h"

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

// The corners of a convex face in a plane, put into order around their middle.
std::vector<Vec3> ordered(const std::vector<Vec3>& corners, Vec3 normal) {
  Vec3 middle;
  for (const Vec3 p : corners) middle = middle + p;
  middle = 1 / static_cast<double>(corners.size()) * middle;
  const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3{1, 0, 0}
                    : size.y <= size.z                   ? Vec3{0, 1, 0}
                                                         : Vec3{0, 0, 1};
  const Vec3 u = cross(normal, axis), v = cross(normal, u);
  // Diamond angle: grows with the angle, made of divisions only.
  const auto turn = [&](Vec3 p) {
    const double x = dot(p - middle, u), y = dot(p - middle, v) / length(normal);
    const double sum = std::abs(x) + std::abs(y);
    if (!(sum > 0)) return 0.0;
    return y >= 0 ? 1 - x / sum : 3 + x / sum;
  };
  std::vector<Vec3> result = corners;
  std::stable_sort(result.begin(), result.end(), [&](Vec3 a, Vec3 b) { return turn(a) < turn(b); });
  return result;
}

Vec3 between(Vec3 back, double back_side, Vec3 front, double front_side) {
  const double share = back_side / (back_side - front_side);
  return back + share * (front - back);
}

}  // namespace

std::vector<Vec3> behind(const std::vector<Vec3>& polygon, const BspPlane& plane) {
  std::vector<Vec3> kept;
  bool strictly = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 p = polygon[i], q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double a = side_of(plane, p), b = side_of(plane, q);
    strictly = strictly || a < 0;
    if (a <= 0) kept.push_back(p);
    if (a < 0 && b > 0) kept.push_back(between(p, a, q, b));
    if (a > 0 && b < 0) kept.push_back(between(q, b, p, a));
  }
  if (!strictly || kept.size() < 3) kept.clear();
  return kept;
}

BspCell::BspCell(const Box3& box) {
  const auto corner = [&](int i) {
    return Vec3{(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                (i & 4) != 0 ? box.high.z : box.low.z};
  };
  faces_ = {
      {corner(0), corner(2), corner(3), corner(1)}, {corner(4), corner(5), corner(7), corner(6)},
      {corner(0), corner(1), corner(5), corner(4)}, {corner(2), corner(6), corner(7), corner(3)},
      {corner(0), corner(4), corner(6), corner(2)}, {corner(1), corner(3), corner(7), corner(5)}};
}

BspCell BspCell::behind_of(const BspPlane& plane) const {
  BspCell part;
  std::vector<Vec3> cut;
  for (const auto& face : faces_) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 p = face[i], q = face[i + 1 < face.size() ? i + 1 : 0];
      const double a = side_of(plane, p), b = side_of(plane, q);
      if (a == 0) cut.push_back(p);
      // Each edge belongs to two faces, once in each direction.
      if (a < 0 && b > 0) cut.push_back(between(p, a, q, b));
    }
    auto kept = behind(face, plane);
    if (!kept.empty()) part.faces_.push_back(std::move(kept));
  }
  if (part.faces_.size() == faces_.size() && cut.empty()) return part;
  if (part.faces_.empty() || cut.size() < 3) return part;
  part.faces_.push_back(ordered(cut, plane.normal));
  return part;
}

Vec3 BspCell::middle() const {
  Vec3 sum;
  double count = 0;
  for_each_corner([&](Vec3 p) {
    sum = sum + p;
    ++count;
  });
  return 1 / count * sum;
}

}  // namespace slipstick
