#include "tests/support/flood.h"

#include <utility>
#include <vector>

namespace slipstick::test {
namespace {

int count(const BitImage& image, bool inside, int neighbours) {
  std::vector<char> seen(static_cast<std::size_t>(image.columns() * image.rows()));
  const auto at = [&](int c, int r) -> char& {
    return seen[static_cast<std::size_t>(r * image.columns() + c)];
  };
  int found = 0;
  for (int row = 0; row < image.rows(); ++row) {
    for (int column = 0; column < image.columns(); ++column) {
      if (image.at(column, row) != inside || at(column, row) != 0) continue;
      ++found;
      std::vector<std::pair<int, int>> todo{{column, row}};
      at(column, row) = 1;
      while (!todo.empty()) {
        const auto [c, r] = todo.back();
        todo.pop_back();
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (neighbours == 4 && dx != 0 && dy != 0) continue;
            const int x = c + dx, y = r + dy;
            if (x < 0 || y < 0 || x >= image.columns() || y >= image.rows()) continue;
            if (image.at(x, y) != inside || at(x, y) != 0) continue;
            at(x, y) = 1;
            todo.emplace_back(x, y);
          }
        }
      }
    }
  }
  return found;
}

}  // namespace

int components(const BitImage& image, int neighbours) {
  return count(image, true, neighbours);
}

int holes(const BitImage& image, int neighbours) {
  return count(image, false, neighbours) - 1;
}

std::size_t count_sticks(const BitImage& image) {
  std::size_t sticks = 0;
  for (int row = 0; row < image.rows(); ++row) {
    for (int column = 0; column < image.columns(); ++column) {
      sticks += image.at(column, row) != image.at(column + 1, row) ? 1U : 0U;
      sticks += image.at(column, row) != image.at(column, row + 1) ? 1U : 0U;
    }
  }
  return sticks;
}

}  // namespace slipstick::test
