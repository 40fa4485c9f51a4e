#include "sim/regions.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace slipstick {

namespace {

constexpr int kWordBits = 64;

/// Calls visit(begin, end) for each run of set pixels of a row of `columns`, or of clear ones.
template <typename Visit>
void for_runs(std::span<const std::uint64_t> words, int columns, std::uint64_t invert, Visit visit) {
  int begin = -1;  // Of the run we are in; -1 between runs.
  for (std::size_t w = 0; w < words.size(); ++w) {
    std::uint64_t word = words[w] ^ invert;
    const int base = static_cast<int>(w) * kWordBits;
    int at = 0;
    while (at < kWordBits) {
      const std::uint64_t rest = (begin < 0 ? word : ~word) >> at;
      if (rest == 0) break;
      at += std::countr_zero(rest);
      if (begin < 0) {
        begin = base + at;
      } else {
        visit(begin, std::min(base + at, columns));
        begin = -1;
      }
    }
  }
  if (begin >= 0 && begin < columns) visit(begin, columns);
}

std::vector<PixelRun> runs_of(const PixelImage& image, std::uint64_t invert) {
  std::vector<PixelRun> runs;
  for (int r = 0; r < image.frame().rows; ++r) {
    for_runs(image.row(r), image.frame().columns, invert, [&](int begin, int end) {
      if (begin < end) runs.push_back({r, begin, end, 0});
    });
  }
  return runs;
}

int root_of(std::vector<int>& parents, int i) {
  const auto at = [&](int k) -> int& { return parents[static_cast<std::size_t>(k)]; };
  while (at(i) != i) {
    at(i) = at(at(i));
    i = at(i);
  }
  return i;
}

}  // namespace

Regions Regions::of_set(const PixelImage& image) {
  Regions regions;
  regions.runs_ = runs_of(image, 0);
  regions.connect(1);
  return regions;
}

Regions Regions::of_free(const PixelImage& image) {
  Regions regions;
  regions.runs_ = runs_of(image, ~std::uint64_t{0});
  regions.connect(0);
  return regions;
}

/// Joins runs of neighbouring rows that overlap when one is widened by `reach` on both sides.
void Regions::connect(int reach) {
  std::vector<int> parents(runs_.size());
  std::iota(parents.begin(), parents.end(), 0);
  std::size_t above = 0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const PixelRun& run = runs_[i];
    while (runs_[above].row < run.row - 1 ||
           (runs_[above].row == run.row - 1 && runs_[above].end + reach <= run.begin)) {
      ++above;
    }
    for (std::size_t k = above; runs_[k].row == run.row - 1 && runs_[k].begin < run.end + reach; ++k) {
      const int upper = root_of(parents, static_cast<int>(k));
      parents[static_cast<std::size_t>(root_of(parents, static_cast<int>(i)))] = upper;
    }
  }
  // Roots are not always first in order, so they get their numbers first.
  std::vector<int> numbers(runs_.size(), -1);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    int& number = numbers[static_cast<std::size_t>(root_of(parents, static_cast<int>(i)))];
    if (number < 0) number = count_++;
    runs_[i].region = number;
  }
}

std::vector<Overlap> overlaps(const Regions& a, const Regions& b) {
  std::vector<Overlap> pairs;
  const auto left = a.runs();
  const auto right = b.runs();
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < left.size() && k < right.size()) {
    const PixelRun& p = left[i];
    const PixelRun& q = right[k];
    const int common = p.row == q.row ? std::min(p.end, q.end) - std::max(p.begin, q.begin) : 0;
    if (common > 0) pairs.push_back({p.region, q.region, common});
    if (std::tie(p.row, p.end) < std::tie(q.row, q.end)) {
      ++i;
    } else {
      ++k;
    }
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const Overlap& x, const Overlap& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  std::vector<Overlap> merged;
  for (const Overlap& pair : pairs) {
    if (!merged.empty() && merged.back().a == pair.a && merged.back().b == pair.b) {
      merged.back().pixels += pair.pixels;
    } else {
      merged.push_back(pair);
    }
  }
  return merged;
}

}  // namespace slipstick
