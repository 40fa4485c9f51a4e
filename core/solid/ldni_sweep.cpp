#include "core/solid/ldni_sweep.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace slipstick {
namespace {

// Points with the axis of the rays as x, the axis across in a plane as y, that of the planes as z.
Vec3 turned(Vec3 p, std::size_t axis) {
  return axis == 0 ? p : axis == 1 ? Vec3{p.y, p.z, p.x} : Vec3{p.z, p.x, p.y};
}

// Planes or rows, one a width.
struct Lines {
  double origin;
  double width;
  int count;

  [[nodiscard]] double at(int line) const { return origin + line * width; }
  // The first at `place` or beyond; `count` if none is.
  [[nodiscard]] int from(double place) const {
    int line = static_cast<int>(std::clamp(std::ceil((place - origin) / width), 0.0, count * 1.0));
    while (line > 0 && at(line - 1) >= place) --line;
    while (line < count && at(line) < place) ++line;
    return line;
  }
};

struct Crossing {
  std::uint32_t row;
  std::uint32_t depth;
  std::uint32_t triangle;
  int turn;
};

class Sweep {
 public:
  Sweep(const MeshModel& model, const LdniGrid& grid, std::size_t axis)
      : mesh_(model.mesh()),
        winding_(model.winding()),
        grid_(grid),
        axis_(axis),
        origin_(turned(grid.origin(), axis)),
        rows_{origin_.y, grid.width(), grid.resolution()},
        planes_{origin_.z, grid.width(), grid.resolution()} {
    sort_by_first_plane();
  }

  LdniSwept run() {
    result_.rays.first.reserve(grid_.rays() + 1);
    for (int plane = 0; plane < planes_.count; ++plane) {
      cross(plane);
      close(plane);
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return {turned(mesh_.vertices[a], axis_), turned(mesh_.vertices[b], axis_),
            turned(mesh_.vertices[c], axis_)};
  }

  // Counting sort; a triangle that no plane meets ends behind all of them.
  void sort_by_first_plane() {
    starts_.assign(static_cast<std::size_t>(planes_.count) + 2, 0);
    const auto first_plane = [&](std::uint32_t t) {
      const auto p = corners(t);
      return static_cast<std::size_t>(planes_.from(std::min({p[0].z, p[1].z, p[2].z})));
    };
    const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
    for (std::uint32_t t = 0; t < count; ++t) ++starts_[first_plane(t) + 1];
    for (std::size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    std::vector<std::uint32_t> next = starts_;
    order_.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) order_[next[first_plane(t)]++] = t;
  }

  // Where the rays of a plane cross triangles, by row and depth.
  void cross(int plane) {
    const double z = planes_.at(plane);
    const auto k = static_cast<std::size_t>(plane);
    active_.insert(active_.end(), order_.begin() + starts_[k], order_.begin() + starts_[k + 1]);
    std::erase_if(active_, [&](std::uint32_t t) {
      const auto p = corners(t);
      return std::max({p[0].z, p[1].z, p[2].z}) <= z;
    });
    crossings_.clear();
    for (const std::uint32_t t : active_) {
      if (const auto cut = cut_of(corners(t), z)) add(*cut, t);
    }
    std::ranges::sort(crossings_, {}, [](const Crossing& c) {
      return std::tuple(c.row, c.depth, c.triangle, c.turn);
    });
  }

  void add(const OutlineSegment& cut, std::uint32_t triangle) {
    for (int row = rows_.from(cut.low.y); row < rows_.count && rows_.at(row) < cut.high.y; ++row) {
      const double widths = (crossing_x(cut, rows_.at(row)) - origin_.x) / grid_.width();
      crossings_.push_back({static_cast<std::uint32_t>(row),
                            static_cast<std::uint32_t>(std::lround(widths * LdniGrid::kUnits)),
                            triangle, cut.turn});
    }
  }

  void close(int plane) {
    std::size_t next = 0;
    for (int row = 0; row < rows_.count; ++row) {
      const std::size_t first = next;
      while (next < crossings_.size() && crossings_[next].row == static_cast<std::uint32_t>(row)) {
        ++next;
      }
      close_ray(std::span(crossings_).subspan(first, next - first), grid_.ray(row, plane));
    }
  }

  // Crossings at one depth count together, so that shells that touch have no void between them.
  void close_ray(std::span<const Crossing> crossings, std::size_t ray) {
    std::vector<LdniSample>& samples = result_.rays.samples;
    const std::size_t begin = samples.size();
    int turns = 0;
    bool inside = false;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const Crossing& c = crossings[i];
      turns += counted(winding_, c.turn);
      if (i + 1 < crossings.size() && crossings[i + 1].depth == c.depth) continue;
      if (is_inside(winding_, turns) == inside) continue;
      inside = !inside;
      samples.push_back({c.depth, normal_of(c.triangle)});
    }
    if (inside) {
      samples.resize(begin);
      result_.open.push_back(ray);
    }
    result_.rays.end_ray();
  }

  [[nodiscard]] LdniNormal normal_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Vec3 p = mesh_.vertices[a];
    const Vec3 normal = slipstick::cross(mesh_.vertices[b] - p, mesh_.vertices[c] - p);
    const Vec3 along = turned({1, 0, 0}, (3 - axis_) % 3);
    return LdniNormal::of(normal).value_or(*LdniNormal::of(along));
  }

  const TriangleMesh& mesh_;
  Winding winding_;
  const LdniGrid& grid_;
  std::size_t axis_;
  Vec3 origin_;
  Lines rows_;
  Lines planes_;
  std::vector<std::uint32_t> starts_;  // of each plane in order_
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> active_;
  std::vector<Crossing> crossings_;
  LdniSwept result_;
};

}  // namespace

LdniSwept swept(const MeshModel& mesh, const LdniGrid& grid, std::size_t axis) {
  return Sweep(mesh, grid, axis).run();
}

}  // namespace slipstick
