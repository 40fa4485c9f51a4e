#include "sim/regions.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "sim/pixel_runs.h"

namespace slipstick {

namespace {

std::vector<PixelRun> runs_of(const PixelImage& image, std::uint64_t invert) {
  std::vector<PixelRun> runs;
  for (int r = 0; r < image.frame().rows; ++r) {
    for_runs(image.row(r), image.frame().columns, invert, [&](int begin, int end) {
      if (begin < end) runs.push_back({r, begin, end, 0, 0});
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

/// A place where a row goes into a loop or out of it.
struct Crossing {
  int row;
  double x;
  int loop;
};

std::vector<Crossing> crossings_of(const PixelFrame& frame,
                                   const std::vector<std::vector<Vec2>>& loops) {
  std::vector<Crossing> crossings;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      Vec2 low = loops[l][i];
      Vec2 high = loops[l][i + 1 < loops[l].size() ? i + 1 : 0];
      if (low.y > high.y) std::swap(low, high);
      const int end = frame.row_from(high.y);
      for (int r = frame.row_from(low.y); r < end; ++r) {
        const double t = (frame.centre_y(r) - low.y) / (high.y - low.y);
        crossings.push_back({r, low.x + t * (high.x - low.x), static_cast<int>(l)});
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.row, a.x) < std::tie(b.row, b.x);
  });
  return crossings;
}

/// The runs of one side. Along a row loops open and close like brackets; the innermost open one
/// says where we are, and how many are open says on which side.
std::vector<PixelRun> contour_runs(const PixelFrame& frame,
                                   const std::vector<std::vector<Vec2>>& loops, Side side) {
  const std::vector<Crossing> crossings = crossings_of(frame, loops);
  std::vector<PixelRun> runs;
  std::vector<int> open;
  std::size_t next = 0;
  for (int row = 0; row < frame.rows; ++row) {
    int begin = 0;
    const auto end_run = [&](int end) {
      const bool is_solid = open.size() % 2 == 1;
      if (begin < end && is_solid == (side == Side::kSolid)) {
        runs.push_back({row, begin, end, open.empty() ? 0 : open.back() + 1, 0});
      }
      begin = std::max(begin, end);
    };
    for (; next < crossings.size() && crossings[next].row == row; ++next) {
      end_run(frame.column_from(crossings[next].x));
      const int loop = crossings[next].loop;
      if (!open.empty() && open.back() == loop) {
        open.pop_back();
      } else {
        open.push_back(loop);
      }
    }
    end_run(frame.columns);
    open.clear();  // empty already unless rounding has exchanged two crossings
  }
  return runs;
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

Regions Regions::of_contours(const PixelFrame& frame, const std::vector<std::vector<Vec2>>& loops,
                             Side side) {
  Regions regions;
  regions.runs_ = contour_runs(frame, loops, side);
  regions.connect(side == Side::kSolid ? 1 : 0);
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
    for (std::size_t k = above; runs_[k].row == run.row - 1 && runs_[k].begin < run.end + reach;
         ++k) {
      if (runs_[k].label != run.label) continue;
      const int upper = root_of(parents, static_cast<int>(k));
      parents[static_cast<std::size_t>(root_of(parents, static_cast<int>(i)))] = upper;
    }
  }
  // Roots are not always first in order, so they get their numbers first.
  std::vector<int> numbers(runs_.size(), -1);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    int& number = numbers[static_cast<std::size_t>(root_of(parents, static_cast<int>(i)))];
    if (number < 0) {
      number = count_++;
      labels_.push_back(runs_[i].label);
    }
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
  std::sort(pairs.begin(), pairs.end(), [](const Overlap& x, const Overlap& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  });
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
