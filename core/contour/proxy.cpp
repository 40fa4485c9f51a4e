#include "core/contour/proxy.h"

#include <cmath>

namespace slipstick {

Proxy line_through(Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  return {a, (1 / length(d)) * Vec2{-d.y, d.x}};
}

double distortion(Vec2 a, Vec2 b, const Proxy& proxy) {
  const double da = dot(a - proxy.point, proxy.normal);
  const double db = dot(b - proxy.point, proxy.normal);
  return (da * da + db * db + da * db) * length(b - a) / 3;
}

void RegionMoments::add_edge(Vec2 a, Vec2 b) {
  a = a - origin_;
  b = b - origin_;
  const double l = length(b - a);
  // The integral of p·q along an edge on which p and q are linear.
  const auto product = [l](double pa, double pb, double qa, double qb) {
    return l * (2 * pa * qa + pa * qb + pb * qa + 2 * pb * qb) / 6;
  };
  length_ += l;
  first_ = first_ + (l / 2) * (a + b);
  xx_ += product(a.x, b.x, a.x, b.x);
  xy_ += product(a.x, b.x, a.y, b.y);
  yy_ += product(a.y, b.y, a.y, b.y);
}

Proxy RegionMoments::best_proxy() const {
  const Vec2 centre = (1 / length_) * first_;
  const double xx = xx_ - first_.x * centre.x;
  const double xy = xy_ - first_.x * centre.y;
  const double yy = yy_ - first_.y * centre.y;
  // The eigenvector (a, b) of the larger eigenvalue, from the row that does not cancel.
  const double half = (xx - yy) / 2;
  const double root = std::sqrt(half * half + xy * xy);
  Vec2 axis = half >= 0 ? Vec2{root + half, xy} : Vec2{xy, root - half};
  const double norm = length(axis);
  axis = norm > 0 ? (1 / norm) * axis : Vec2{1, 0};
  return {origin_ + centre, {-axis.y, axis.x}};
}

}  // namespace slipstick
