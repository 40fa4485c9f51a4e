#include "core/contour/ledger_runs.h"

#include <bit>
#include <numeric>

namespace slipstick {
namespace {

// The columns at which the bits of a row change, starting from outside, ascending.
void append_changes(std::span<const std::uint64_t> row, std::vector<int>& changes) {
  std::uint64_t before = 0;
  for (std::size_t w = 0; w < row.size(); ++w) {
    std::uint64_t edges = row[w] ^ (row[w] << 1 | before);
    before = row[w] >> (BitImage::kBitsPerWord - 1);
    for (; edges != 0; edges &= edges - 1) {
      changes.push_back(static_cast<int>(w) * BitImage::kBitsPerWord + std::countr_zero(edges));
    }
  }
}

}  // namespace

RunImage::RunImage(const BitImage& image, Of what) {
  std::vector<int> changes;
  begins_.push_back(0);
  for (int row = 0; row < image.rows(); ++row) {
    changes.clear();
    if (what == Of::kOutside) changes.push_back(0);
    append_changes(image.row(row), changes);
    if (what == Of::kOutside) changes.push_back(image.columns());
    for (std::size_t i = 0; i + 1 < changes.size(); i += 2) {
      runs_.push_back({changes[i], changes[i + 1] - 1});
    }
    begins_.push_back(runs_.size());
  }
}

DisjointSets::DisjointSets(std::size_t count) : parent_(count) {
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
}

std::size_t DisjointSets::find(std::size_t i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

void DisjointSets::join(std::size_t i, std::size_t j) {
  i = find(i);
  j = find(j);
  if (i < j) {
    parent_[j] = i;
  } else {
    parent_[i] = j;
  }
}

}  // namespace slipstick
