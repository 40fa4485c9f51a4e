#include "core/image/sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace slipstick {
namespace {

// Nodes a side of the tiles asked about as a whole, coarse to fine; the last are sampled node by
// node.
constexpr int kTileSizeMax = 128;
constexpr int kTileSizeMin = 16;

struct Tile {
  int column;
  int row;
  int columns;
  int rows;
};

class Sampler {
 public:
  explicit Sampler(const SliceGrid& grid) : image_(grid) {}

  void tile(Section& section, const Tile& t, int size) {
    const SliceGrid& grid = image_.grid();
    const Box2 box{{grid.node_x(t.column), grid.node_y(t.row)},
                   {grid.node_x(t.column + t.columns - 1), grid.node_y(t.row + t.rows - 1)}};
    const Section::Narrowed narrowed = section.narrowed(box);
    if (narrowed.cover == Cover::kOutside) return;
    if (narrowed.cover == Cover::kInside) return fill(t);
    Section& inner = narrowed.section ? *narrowed.section : section;
    if (size <= kTileSizeMin) {
      nodes(inner, t);
    } else {
      split(inner, t, size / 2);
    }
    if (!undefined_) undefined_ = inner.undefined_at();
  }

  void split(Section& section, const Tile& t, int size) {
    for (int row = t.row; row < t.row + t.rows; row += size) {
      for (int column = t.column; column < t.column + t.columns; column += size) {
        tile(section,
             {column, row, std::min(size, t.column + t.columns - column),
              std::min(size, t.row + t.rows - row)},
             size);
      }
    }
  }

  [[nodiscard]] const std::optional<Vec2>& undefined() const { return undefined_; }
  [[nodiscard]] BitImage take() { return std::move(image_); }

 private:
  void fill(const Tile& t) { image_.fill(t.column, t.row, t.columns, t.rows); }

  void nodes(Section& section, const Tile& t) {
    const SliceGrid& grid = image_.grid();
    xs_.clear();
    ys_.clear();
    for (int row = t.row; row < t.row + t.rows; ++row) {
      for (int column = t.column; column < t.column + t.columns; ++column) {
        xs_.push_back(grid.node_x(column));
        ys_.push_back(grid.node_y(row));
      }
    }
    inside_.resize(xs_.size());
    section.classify(xs_, ys_, inside_);
    auto inside = inside_.begin();
    for (int row = t.row; row < t.row + t.rows; ++row) {
      for (int column = t.column; column < t.column + t.columns; ++column) {
        if (*inside++ != 0) image_.set(column, row, true);
      }
    }
  }

  BitImage image_;
  std::optional<Vec2> undefined_;
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<std::uint8_t> inside_;
};

tl::unexpected<Error> undefined_error(Vec2 p) {
  return fail(ErrorCode::kInput,
              fmt::format("f is not a number at x={:.4g} y={:.4g}; keep roots, logarithms and "
                          "quotients away from where they are undefined",
                          p.x, p.y));
}

}  // namespace

Result<BitImage> sample(Section& section, const SliceGrid& grid) {
  if (BitImage image(grid); section.paint(image)) {
    if (const auto p = section.undefined_at()) return undefined_error(*p);
    return image;
  }
  Sampler sampler(grid);
  sampler.split(section, {1, 1, grid.columns() - 2, grid.rows() - 2}, kTileSizeMax);
  if (const auto& p = sampler.undefined()) return undefined_error(*p);
  return sampler.take();
}

}  // namespace slipstick
