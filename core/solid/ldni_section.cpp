#include "core/solid/ldni_section.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "core/image/bit_image.h"

namespace slipstick {
namespace {

// Nodes first <= column < end, the same for rows.
struct Block {
  int first_column;
  int end_column;
  int first_row;
  int end_row;
};

template <typename CoverOf, typename Inside>
class Painter {
 public:
  Painter(BitImage& image, CoverOf cover, Inside inside)
      : image_(image), cover_(cover), inside_(inside) {}

  void paint(const Block& b) const {
    constexpr int kFew = 4;  // nodes a side: smaller blocks are asked node by node
    const SliceGrid& grid = image_.grid();
    const Cover cover = cover_(Box2{{grid.node_x(b.first_column), grid.node_y(b.first_row)},
                                    {grid.node_x(b.end_column - 1), grid.node_y(b.end_row - 1)}});
    const int columns = b.end_column - b.first_column, rows = b.end_row - b.first_row;
    if (cover == Cover::kOutside) return;
    if (cover == Cover::kInside) return image_.fill(b.first_column, b.first_row, columns, rows);
    if (std::max(columns, rows) <= kFew) return nodes(b);
    if (columns >= rows) {
      const int middle = b.first_column + columns / 2;
      paint({b.first_column, middle, b.first_row, b.end_row});
      paint({middle, b.end_column, b.first_row, b.end_row});
    } else {
      const int middle = b.first_row + rows / 2;
      paint({b.first_column, b.end_column, b.first_row, middle});
      paint({b.first_column, b.end_column, middle, b.end_row});
    }
  }

 private:
  void nodes(const Block& b) const {
    const SliceGrid& grid = image_.grid();
    for (int row = b.first_row; row < b.end_row; ++row) {
      for (int column = b.first_column; column < b.end_column; ++column) {
        if (inside_(grid.node_x(column), grid.node_y(row))) image_.set(column, row, true);
      }
    }
  }

  BitImage& image_;
  CoverOf cover_;
  Inside inside_;
};

}  // namespace

LdniSection::LdniSection(std::shared_ptr<const LdniModel::Parts> parts, const Affine3& to_widths,
                         double z)
    : parts_(std::move(parts)), to_widths_(to_widths), z_(z), sight_(parts_->ldni) {}

LdniPoint LdniSection::at(double x, double y) const {
  const Vec3 p = to_widths_({x, y, z_});
  return {p.x, p.y, p.z};
}

void LdniSection::classify(std::span<const double> xs, std::span<const double> ys,
                           std::span<std::uint8_t> inside) {
  SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == inside.size());
  for (std::size_t i = 0; i < xs.size(); ++i) {
    inside[i] = sight_.value(at(xs[i], ys[i])) <= 0 ? std::uint8_t{1} : std::uint8_t{0};
  }
}

// Rounding is monotone, so each coordinate is least and greatest at a corner, bit for bit.
LdniSection::Range LdniSection::range_of(const Box2& box) const {
  const LdniPoint first = at(box.low.x, box.low.y);
  Range range{first, first};
  for (const Vec2 corner : {Vec2{box.high.x, box.low.y}, Vec2{box.low.x, box.high.y}, box.high}) {
    const LdniPoint p = at(corner.x, corner.y);
    for (std::size_t k = 0; k < 3; ++k) {
      range.low[k] = std::min(range.low[k], p[k]);
      range.high[k] = std::max(range.high[k], p[k]);
    }
  }
  return range;
}

Cover LdniSection::cover(const Box2& box) const {
  constexpr double kFew = 20;  // widths a side: the rays of larger boxes are too many to be asked
  const Range range = range_of(box);
  const Cover cover = parts_->blocks.cover(range.low, range.high);
  if (cover != Cover::kMixed) return cover;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(range.high[k] - range.low[k] <= kFew)) return Cover::kMixed;
  }
  return sight_.cover(range.low, range.high);
}

Section::Narrowed LdniSection::narrowed(const Box2& box) {
  return {cover(box), nullptr};
}

bool LdniSection::paint(BitImage& image) {
  const Painter painter(
      image, [this](const Box2& box) { return cover(box); },
      [this](double x, double y) { return sight_.value(at(x, y)) <= 0; });
  painter.paint({1, image.columns() - 1, 1, image.rows() - 1});
  return true;
}

bool LdniSection::evaluate(std::span<const double> xs, std::span<const double> ys,
                           std::span<double> values) {
  SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == values.size());
  for (std::size_t i = 0; i < xs.size(); ++i) values[i] = sight_.value(at(xs[i], ys[i]));
  return true;
}

}  // namespace slipstick
