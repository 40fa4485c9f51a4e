#include "core/region/regularize.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/check.h"

namespace slipstick {
namespace {

// Nodes beside the middle of a disc's rows: `half_widths[dy]` for dy = 0, 1, …; empty if the disc
// is.
std::vector<int> half_widths(double square, double h) {
  std::vector<int> widths;
  for (int dy = 0; square >= dy * h * (dy * h); ++dy) {
    widths.push_back(static_cast<int>(std::sqrt((square - dy * h * (dy * h)) / (h * h))));
  }
  return widths;
}

// Counts, for each node, how many rows of discs hold it, by differences along the row.
class Cover {
 public:
  explicit Cover(const SliceGrid& grid) : columns_(grid.columns()), rows_(grid.rows()) {
    starts_.resize(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_ + 1));
  }

  // All nodes first <= column <= last of a row; cut off at the image.
  void add(int row, int first, int last) {
    if (row < 0 || row >= rows_) return;
    const int low = std::max(first, 0), high = std::min(last, columns_ - 1);
    if (low > high) return;
    ++at(row, low);
    --at(row, high + 1);
  }

  int& at(int row, int column) {
    return starts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
                   static_cast<std::size_t>(column)];
  }

 private:
  int columns_;
  int rows_;
  std::vector<int> starts_;
};

enum class Nodes : std::uint8_t { kInside, kOutside };

// Adds the disc about every run of such nodes in a row: a run grows as a whole.
void add_runs(Cover& cover, const BitImage& image, Nodes nodes, std::span<const int> widths) {
  const bool wanted = nodes == Nodes::kInside;
  const auto reach = static_cast<int>(widths.size()) - 1;
  for (int row = 0; row < image.rows(); ++row) {
    for (int column = 0; column < image.columns();) {
      if (image.at(column, row) != wanted) {
        ++column;
        continue;
      }
      const int first = column;
      while (column < image.columns() && image.at(column, row) == wanted) ++column;
      for (int dy = -reach; dy <= reach; ++dy) {
        const int width = widths[static_cast<std::size_t>(std::abs(dy))];
        cover.add(row + dy, first - width, column - 1 + width);
      }
    }
  }
}

// The nodes that the balls about all such nodes of the window hold, or all others.
BitImage reached(std::span<const BitImage* const> window, const DiscreteBall& ball, Nodes nodes) {
  const int reach = ball.reach();
  SLIPSTICK_CHECK(window.size() == 2 * static_cast<std::size_t>(reach) + 1);
  const SliceGrid& grid = window[0]->grid();
  Cover cover(grid);
  for (std::size_t i = 0; i < window.size(); ++i) {
    const double height = (static_cast<int>(i) - reach) * ball.spacing;
    const double square = std::max(ball.radius * ball.radius - height * height, 0.0);
    const BitImage& image = *window[i];
    SLIPSTICK_CHECK(image.grid() == grid);
    add_runs(cover, image, nodes, half_widths(square, grid.width()));
  }
  BitImage result(grid);
  for (int row = 1; row < grid.rows() - 1; ++row) {
    int count = cover.at(row, 0);
    for (int column = 1; column < grid.columns() - 1; ++column) {
      count += cover.at(row, column);
      if ((count > 0) == (nodes == Nodes::kInside)) result.set(column, row, true);
    }
  }
  return result;
}

}  // namespace

int DiscreteBall::reach() const {
  return static_cast<int>(std::floor(radius / spacing));
}

BitImage dilated(std::span<const BitImage* const> window, const DiscreteBall& ball) {
  return reached(window, ball, Nodes::kInside);
}

BitImage eroded(std::span<const BitImage* const> window, const DiscreteBall& ball) {
  return reached(window, ball, Nodes::kOutside);
}

}  // namespace slipstick
