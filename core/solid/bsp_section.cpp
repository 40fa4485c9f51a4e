#include "core/solid/bsp_section.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/image/bit_image.h"

namespace slipstick {
namespace {

// A line of the section: in front where the value is positive.
struct Line {
  double x;
  double y;
  double offset;

  [[nodiscard]] double value(Vec2 p) const { return (x * p.x + y * p.y) + offset; }
  [[nodiscard]] bool in_front(double px, double py) const { return value({px, py}) > 0; }
};

Line line_at(const PlacedBspNode& node, double z) {
  return {node.x, node.y, node.z * z + node.offset};
}

enum class Side : std::uint8_t { kBack, kFront, kBoth };

// Of a rectangle: the value is monotone in x and in y, so that two corners bound it.
Side side_of(const Line& line, const Box2& box) {
  const bool right = line.x > 0, up = line.y > 0;
  const bool highest = line.in_front(right ? box.high.x : box.low.x, up ? box.high.y : box.low.y);
  if (!highest) return Side::kBack;
  const bool lowest = line.in_front(right ? box.low.x : box.high.x, up ? box.low.y : box.high.y);
  return lowest ? Side::kFront : Side::kBoth;
}

// Nodes first <= column < end, the same for rows.
struct Block {
  int first_column;
  int end_column;
  int first_row;
  int end_row;
};

class Painter {
 public:
  Painter(const PlacedBspNodes& nodes, double z, BitImage& image)
      : nodes_(nodes), z_(z), image_(image) {}

  void paint(BspChild at, const Block& b) {
    while (at >= 0) {
      const PlacedBspNode& node = nodes_[static_cast<std::size_t>(at)];
      const Line line = line_at(node, z_);
      const Side side = slipstick::side_of(line, box_of(b));
      if (side == Side::kBoth) return split(at, line, b);
      at = side == Side::kFront ? node.front : node.back;
    }
    if (at == kBspInside) fill(b);
  }

 private:
  [[nodiscard]] Box2 box_of(const Block& b) const {
    const SliceGrid& grid = image_.grid();
    return {{grid.node_x(b.first_column), grid.node_y(b.first_row)},
            {grid.node_x(b.end_column - 1), grid.node_y(b.end_row - 1)}};
  }

  // Columns on one side in all rows of the block go on as one block, and so do those on the other;
  // between them the line runs through, and the block is halved.
  void split(BspChild at, const Line& line, const Block& b) {
    if (line.x == 0) return halve(at, b);
    const int low = change(line, b, b.first_row), high = change(line, b, b.end_row - 1);
    const int left = std::min(low, high), right = std::max(low, high);
    const PlacedBspNode& node = nodes_[static_cast<std::size_t>(at)];
    const bool front_is_right = line.x > 0;
    if (b.first_column < left) {
      paint(front_is_right ? node.back : node.front,
            {b.first_column, left, b.first_row, b.end_row});
    }
    if (right < b.end_column) {
      paint(front_is_right ? node.front : node.back, {right, b.end_column, b.first_row, b.end_row});
    }
    if (left < right) halve(at, {left, right, b.first_row, b.end_row});
  }

  void halve(BspChild at, const Block& b) {
    const int middle = b.first_row + (b.end_row - b.first_row) / 2;
    paint(at, {b.first_column, b.end_column, b.first_row, middle});
    paint(at, {b.first_column, b.end_column, middle, b.end_row});
  }

  // The first column of the row that is on the right-hand side of the line; the end of the block if
  // none is. \pre line.x != 0.
  [[nodiscard]] int change(const Line& line, const Block& b, int row) const {
    const SliceGrid& grid = image_.grid();
    const double y = grid.node_y(row);
    const bool right = line.x > 0;
    int low = b.first_column, high = b.end_column;  // the change lies in low..high
    while (low < high) {
      const int middle = low + (high - low) / 2;
      if (line.in_front(grid.node_x(middle), y) == right) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  void fill(const Block& b) {
    for (int row = b.first_row; row < b.end_row; ++row) {
      for (int column = b.first_column; column < b.end_column; ++column) {
        image_.set(column, row, true);
      }
    }
  }

  const PlacedBspNodes& nodes_;
  double z_;
  BitImage& image_;
};

}  // namespace

void BspSection::classify(std::span<const double> xs, std::span<const double> ys,
                          std::span<std::uint8_t> inside) {
  SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() == inside.size());
  for (std::size_t i = 0; i < xs.size(); ++i) {
    BspChild at = root_;
    while (at >= 0) {
      const PlacedBspNode& node = (*nodes_)[static_cast<std::size_t>(at)];
      at = line_at(node, z_).in_front(xs[i], ys[i]) ? node.front : node.back;
    }
    inside[i] = at == kBspInside ? 1 : 0;
  }
}

// Where the way crosses the planes that it meets on its way down, whether they change anything or
// not.
void BspSection::guess_changes(Vec2 from, Vec2 to, std::vector<double>& shares) {
  shares.clear();
  pieces_.assign(1, {root_, 0, 1});
  while (!pieces_.empty()) {
    const Piece piece = pieces_.back();
    pieces_.pop_back();
    if (piece.at < 0) continue;
    const PlacedBspNode& node = (*nodes_)[static_cast<std::size_t>(piece.at)];
    const Line line = line_at(node, z_);
    const double first = line.value(from + piece.begin * (to - from));
    const double last = line.value(from + piece.end * (to - from));
    if (first > 0 && last > 0) {
      pieces_.push_back({node.front, piece.begin, piece.end});
    } else if (!(first > 0 || last > 0)) {
      pieces_.push_back({node.back, piece.begin, piece.end});
    } else {
      const double share = piece.begin + first / (first - last) * (piece.end - piece.begin);
      shares.push_back(share);
      pieces_.push_back({first > 0 ? node.front : node.back, piece.begin, share});
      pieces_.push_back({first > 0 ? node.back : node.front, share, piece.end});
    }
  }
}

Section::Narrowed BspSection::narrowed(const Box2& box) {
  BspChild at = root_;
  while (at >= 0) {
    const PlacedBspNode& node = (*nodes_)[static_cast<std::size_t>(at)];
    const Side side = side_of(line_at(node, z_), box);
    if (side == Side::kBoth) break;
    at = side == Side::kFront ? node.front : node.back;
  }
  if (at < 0) return {at == kBspInside ? Cover::kInside : Cover::kOutside, nullptr};
  if (at == root_) return {};
  return {Cover::kMixed, std::make_unique<BspSection>(nodes_, at, z_)};
}

bool BspSection::paint(BitImage& image) {
  Painter painter(*nodes_, z_, image);
  painter.paint(root_, {1, image.columns() - 1, 1, image.rows() - 1});
  return true;
}

}  // namespace slipstick
