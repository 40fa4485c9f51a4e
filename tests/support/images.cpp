#include "tests/support/images.h"

#include <cmath>
#include <functional>

#include "core/base/check.h"

namespace slipstick::test {
namespace {

using Rule = std::function<bool(int column, int row)>;

BitImage drawn(int columns, int rows, const Rule& rule) {
  BitImage image(small_grid(columns, rows));
  // The window has two nodes of margin on each side.
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (rule(column, row)) image.set(column + 2, row + 2, true);
    }
  }
  return image;
}

Rule rule_of(Rng& rng, int n) {
  const auto pick = [&rng](int bound) {
    return static_cast<int>(rng.below(static_cast<std::uint64_t>(bound)));
  };
  const double cx = rng.unit() * n, cy = rng.unit() * n, r = rng.unit() * n / 2 + 0.5;
  const double slope = rng.unit() * 4 - 2, wide = rng.unit() * 3 + 0.3;
  const int period = 2 + pick(4), offset = pick(n);
  const auto far = [cx, cy](int c, int row) { return std::hypot(c - cx, row - cy); };
  switch (pick(12)) {
    case 0:
      return [=](int c, int row) { return far(c, row) <= r; };
    case 1:
      return [=](int c, int row) { return std::abs(far(c, row) - r) <= wide / 2; };
    case 2:
      return [=](int c, int row) { return (c + row) % 2 == offset % 2; };
    case 3:
      return [=](int c, int row) { return c % period == 0 || row == offset; };
    case 4:
      return [=](int c, int row) { return std::abs(row - slope * c - offset) <= wide; };
    case 5:
      return [=](int c, int row) { return row <= slope * c + offset; };
    case 6:
      return [=](int c, int row) { return c == row || c + row == n - 1; };
    case 7:  // a spiral of square turns
      return [=](int c, int row) {
        const int ring = std::max(std::abs(c - n / 2), std::abs(row - n / 2));
        return ring % 2 == 0 || (c == n / 2 + ring && row == n / 2);
      };
    case 8:
      return [=](int c, int row) { return (c / period + row / period) % 2 == 0; };
    case 9:
      return [=](int c, int row) { return far(c, row) <= r || far(c, row) >= r + wide; };
    case 10:
      return [=](int, int) { return offset % 2 == 0; };
    default:
      return [=](int c, int row) { return c == offset && row == n / 2; };
  }
}

}  // namespace

SliceGrid small_grid(int columns, int rows) {
  constexpr double kWidth =
      0.125;  // a power of two, so that the nodes are where they are asked to be
  const Box2 area{{0, 0}, {(columns - 1) * kWidth, (rows - 1) * kWidth}};
  const auto grid = SliceGrid::over(area, kWidth);
  SLIPSTICK_CHECK(grid && grid->columns() == columns + 4 && grid->rows() == rows + 4);
  return *grid;
}

BitImage image_of(const std::vector<std::string>& picture) {
  const int rows = static_cast<int>(picture.size());
  return drawn(static_cast<int>(picture[0].size()), rows, [&](int column, int row) {
    return picture[static_cast<std::size_t>(rows - 1 - row)][static_cast<std::size_t>(column)] ==
           '#';
  });
}

std::vector<std::string> picture_of(const BitImage& image) {
  std::vector<std::string> picture;
  for (int row = image.rows() - 3; row >= 2; --row) {
    std::string line;
    for (int column = 2; column < image.columns() - 2; ++column) {
      line += image.at(column, row) ? '#' : '.';
    }
    picture.push_back(line);
  }
  return picture;
}

BitImage noise(Rng& rng, int columns, int rows, double density) {
  return drawn(columns, rows, [&](int, int) { return rng.unit() < density; });
}

BitImage structured(Rng& rng) {
  const int n = 3 + static_cast<int>(rng.below(30));
  const Rule rule = rule_of(rng, n);
  return drawn(n, n, rule);
}

}  // namespace slipstick::test
