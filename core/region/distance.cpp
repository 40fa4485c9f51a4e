#include "core/region/distance.h"

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

double to_segment(Vec2 p, Vec2 a, Vec2 edge, double inverse_square) {
  const Vec2 v = p - a;
  const double t = std::clamp(dot(v, edge) * inverse_square, 0.0, 1.0);
  const Vec2 away = v - t * edge;
  return dot(away, away);
}

}  // namespace

DistanceField::DistanceField(const BitImage& image, const Outline& outline, double reach)
    : grid_(image.grid()),
      reach_(static_cast<float>(reach)),
      distances_(static_cast<std::size_t>(image.columns()) *
                 static_cast<std::size_t>(image.rows())) {
  for (int row = 0; row < image.rows(); ++row) {
    for (int column = 0; column < image.columns(); ++column) {
      if (image.at(column, row)) {
        distances_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns()) +
                   static_cast<std::size_t>(column)] = reach_ * reach_;
      }
    }
  }
  for (const Outline::Loop& loop : outline.loops()) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const std::size_t next = i + 1 < loop.points.size() ? i + 1 : 0;
      approach(outline.mm(loop.points[i]), outline.mm(loop.points[next]), image);
    }
  }
  for (float& d : distances_) d = std::sqrt(d);
}

double DistanceField::at(int column, int row) const {
  if (column < 0 || row < 0 || column >= grid_.columns() || row >= grid_.rows()) return 0;
  return distances_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns()) +
                    static_cast<std::size_t>(column)];
}

BitImage DistanceField::at_least(double level) const {
  BitImage image(grid_);
  const auto limit = static_cast<float>(level);
  for (int row = 1; row < grid_.rows() - 1; ++row) {
    for (int column = 1; column < grid_.columns() - 1; ++column) {
      if (at(column, row) >= limit) image.set(column, row, true);
    }
  }
  return image;
}

// Lowers the squared distances of the nodes within reach of an edge.
void DistanceField::approach(Vec2 a, Vec2 b, const BitImage& image) {
  const Vec2 edge = b - a;
  const double inverse_square = 1 / dot(edge, edge);
  const double h = grid_.width();
  const auto first = [&](double p, double q, std::int64_t origin) {
    const double at = std::floor((std::min(p, q) - reach_) / h) - static_cast<double>(origin);
    return static_cast<int>(std::max(at, 0.0));
  };
  const auto last = [&](double p, double q, std::int64_t origin, int count) {
    const double at = std::ceil((std::max(p, q) + reach_) / h) - static_cast<double>(origin);
    return static_cast<int>(std::min(at, count - 1.0));
  };
  const int left = first(a.x, b.x, grid_.first_column());
  const int right = last(a.x, b.x, grid_.first_column(), grid_.columns());
  const int top = last(a.y, b.y, grid_.first_row(), grid_.rows());
  for (int row = first(a.y, b.y, grid_.first_row()); row <= top; ++row) {
    const double y = grid_.node_y(row);
    float* line =
        &distances_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns())];
    for (int column = left; column <= right; ++column) {
      if (!image.at(column, row)) continue;
      const Vec2 node{grid_.node_x(column), y};
      const auto d = static_cast<float>(to_segment(node, a, edge, inverse_square));
      line[column] = std::min(line[column], d);
    }
  }
}

}  // namespace slipstick
