#include "core/toolpath/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/angle.h"

namespace slipstick {
namespace {

// The polygons turned so that rows lie along x, and the way back.
class Turned {
 public:
  Turned(const std::vector<std::vector<Vec2>>& polygons, double degrees) {
    along_ = direction_of(degrees);
    for (const auto& polygon : polygons) {
      polygons_.emplace_back();
      for (const Vec2 p : polygon) {
        polygons_.back().push_back({dot(p, along_), cross(along_, p)});
      }
    }
  }

  [[nodiscard]] const std::vector<std::vector<Vec2>>& polygons() const { return polygons_; }
  [[nodiscard]] Vec2 back(Vec2 p) const {
    return {p.x * along_.x - p.y * along_.y, p.x * along_.y + p.y * along_.x};
  }

 private:
  Vec2 along_;
  std::vector<std::vector<Vec2>> polygons_;
};

struct Crossing {
  double x;
  std::size_t polygon;
};

// Where row y crosses the borders, from left to right: always an even number.
std::vector<Crossing> crossings(const Turned& turned, double y) {
  std::vector<Crossing> result;
  for (std::size_t i = 0; i < turned.polygons().size(); ++i) {
    const auto& polygon = turned.polygons()[i];
    for (std::size_t j = 0; j < polygon.size(); ++j) {
      const Vec2 a = polygon[j], b = polygon[j + 1 < polygon.size() ? j + 1 : 0];
      if ((a.y <= y) == (b.y <= y)) continue;
      result.push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), i});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  return result;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Extent height_of(const std::vector<std::vector<Vec2>>& polygons) {
  Extent extent;
  for (const auto& polygon : polygons) {
    for (const Vec2 p : polygon) {
      extent = {std::min(extent.low, p.y), std::max(extent.high, p.y)};
    }
  }
  return extent;
}

// Heights of the regular rows that meet the polygons.
std::vector<double> rows_of(const Turned& turned, double spacing) {
  std::vector<double> rows;
  const Extent extent = height_of(turned.polygons());
  if (!std::isfinite(spacing) || extent.low > extent.high) return rows;
  const double first = std::ceil(extent.low / spacing - 0.5);
  const double count = std::floor(extent.high / spacing - 0.5) - first + 1;
  for (int i = 0; i < count; ++i) rows.push_back((first + i + 0.5) * spacing);
  return rows;
}

// Which polygons hang together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  // Whether they were apart.
  bool join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::size_t> parents_;
};

void join_along(const std::vector<Crossing>& row, Groups& groups) {
  for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
    groups.join(row[i].polygon, row[i + 1].polygon);
  }
}

// A height just beside a polygon's leftmost vertex, where the row to its left belongs to the inside
// if the polygon is a hole.
double leftmost_height(const std::vector<Vec2>& polygon) {
  const auto left =
      std::min_element(polygon.begin(), polygon.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  const auto next = left + 1 == polygon.end() ? polygon.begin() : left + 1;
  constexpr double kBeside = 1e-3;  // of the edge
  return left->y + kBeside * (next->y - left->y);
}

}  // namespace

std::vector<RasterLine> raster(const std::vector<std::vector<Vec2>>& polygons,
                               const RasterOptions& options) {
  const Turned turned(polygons, options.angle);
  std::vector<RasterLine> lines;
  bool forth = true;
  for (const double y : rows_of(turned, options.spacing)) {
    const auto row = crossings(turned, y);
    std::vector<RasterLine> pieces;
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      const Vec2 from = turned.back({row[i].x, y}), to = turned.back({row[i + 1].x, y});
      pieces.push_back(forth ? RasterLine{from, to} : RasterLine{to, from});
    }
    if (!forth) std::reverse(pieces.begin(), pieces.end());
    lines.insert(lines.end(), pieces.begin(), pieces.end());
    forth = !forth;
  }
  return lines;
}

std::vector<RasterLine> connecting_lines(const std::vector<std::vector<Vec2>>& polygons,
                                         const RasterOptions& options) {
  const Turned turned(polygons, options.angle);
  Groups groups(polygons.size());
  for (const double y : rows_of(turned, options.spacing)) {
    join_along(crossings(turned, y), groups);
  }
  std::vector<RasterLine> lines;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    // The row left of a hole's leftmost vertex runs through the region to another polygon.
    const double y = leftmost_height(turned.polygons()[i]);
    const auto row = crossings(turned, y);
    for (std::size_t j = 0; j + 1 < row.size(); j += 2) {
      if (row[j].polygon != i && row[j + 1].polygon != i) continue;
      if (!groups.join(row[j].polygon, row[j + 1].polygon)) continue;
      lines.push_back({turned.back({row[j].x, y}), turned.back({row[j + 1].x, y})});
    }
  }
  return lines;
}

}  // namespace slipstick
