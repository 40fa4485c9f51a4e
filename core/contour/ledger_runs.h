#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/image/bit_image.h"

namespace slipstick {

/// Consecutive nodes of one row that are all inside, or all outside.
struct NodeRun {
  int first = 0;
  int last = 0;  ///< Included.
};

/// The rows of an image as runs, left to right, bottom row first.
class RunImage {
 public:
  enum class Of : std::uint8_t { kInside, kOutside };

  RunImage(const BitImage& image, Of what);

  [[nodiscard]] int rows() const { return static_cast<int>(begins_.size()) - 1; }
  [[nodiscard]] std::size_t size() const { return runs_.size(); }
  /// Runs are numbered through all rows; these are the first of `row` and of the next one.
  [[nodiscard]] std::size_t begin(int row) const { return begins_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] std::size_t end(int row) const {
    return begins_[static_cast<std::size_t>(row) + 1];
  }
  [[nodiscard]] NodeRun operator[](std::size_t run) const { return runs_[run]; }

 private:
  std::vector<NodeRun> runs_;
  std::vector<std::size_t> begins_;
};

/// Which cells hang together: those that share a face, or those that share at least a corner.
enum class Touch : std::uint8_t { kFaces, kCorners };

struct RunRow {
  const RunImage& image;
  int row;
};

/// Calls `join(i, j)` for each run i of `one` that touches run j of `other`, a row that may be
/// none.
template <typename Join>
void each_touching(RunRow one, RunRow other, Touch touch, Join join) {
  const RunImage &a = one.image, &b = other.image;
  const int row = one.row, other_row = other.row;
  if (other_row < 0 || other_row >= b.rows()) return;
  const int reach = touch == Touch::kCorners ? 1 : 0;
  std::size_t j = b.begin(other_row);
  for (std::size_t i = a.begin(row); i < a.end(row); ++i) {
    while (j < b.end(other_row) && b[j].last + reach < a[i].first) ++j;
    for (std::size_t k = j; k < b.end(other_row) && b[k].first <= a[i].last + reach; ++k)
      join(i, k);
  }
}

/// Union-find with path halving; the smaller number stands for a set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);

  [[nodiscard]] std::size_t find(std::size_t i);
  void join(std::size_t i, std::size_t j);

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace slipstick
