#pragma once

#include "core/base/vec.h"

namespace slipstick {

/// \file
/// Linear proxies of contour regions and their distortion (paper, section 5.1).

/// A line: a point of it and its unit normal.
struct Proxy {
  Vec2 point;
  Vec2 normal{0, 1};
};

/// The line through two points. \pre They differ.
[[nodiscard]] Proxy line_through(Vec2 a, Vec2 b);

/// Equation (2): the integral of the squared distance from the line over the edge from `a` to `b`.
/// The distances are signed: with absolute ones an edge that crosses the line is overcharged up to
/// threefold.
[[nodiscard]] double distortion(Vec2 a, Vec2 b, const Proxy& proxy);

/// Sums over the edges of a region from which its best proxy follows, equations (3) and (4).
class RegionMoments {
 public:
  /// Coordinates are taken relative to `origin`, a point of the region: raw moments cancel badly.
  explicit RegionMoments(Vec2 origin) : origin_(origin) {}

  void add_edge(Vec2 a, Vec2 b);

  /// The line of least distortion. \pre An edge of positive length was added.
  [[nodiscard]] Proxy best_proxy() const;

 private:
  Vec2 origin_;
  double length_ = 0;
  Vec2 first_;                       // integral of position
  double xx_ = 0, xy_ = 0, yy_ = 0;  // integrals of products
};

}  // namespace slipstick
