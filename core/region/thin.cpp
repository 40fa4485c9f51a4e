#include "core/region/thin.h"

#include <bit>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace slipstick {
namespace {

struct Offset {
  int x;
  int y;
};
constexpr std::array<Offset, 8> kAround{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

constexpr bool has(unsigned set, int i) {
  return ((set >> (i & 7)) & 1U) != 0;
}

// Components of `set` among the eight neighbours, connected also by corners: runs around the
// circle, where an orthogonal gap between two diagonals is bridged by nothing but a diagonal gap
// is.
constexpr int components_8(unsigned set) {
  // A diagonal neighbour missing between two present orthogonal ones does not part them: they touch
  // by a corner.
  for (int i = 1; i < 8; i += 2) {
    if (has(set, i - 1) && has(set, i + 1)) set |= 1U << i;
  }
  int starts = 0;
  for (int i = 0; i < 8; ++i) starts += has(set, i) && !has(set, i + 1) ? 1 : 0;
  return set == 0xFF ? 1 : starts;
}

// Components of `set` connected by sides only that hold an orthogonal neighbour.
constexpr int components_4(unsigned set) {
  int found = 0;
  for (int i = 0; i < 8; i += 2) {
    // Count each run once, at the orthogonal neighbour that ends it.
    const bool goes_on = has(set, i + 1) && has(set, i + 2);
    found += has(set, i) && !goes_on ? 1 : 0;
  }
  const bool ring = (set & 0xFFU) == 0xFFU;
  return ring ? 1 : found;
}

constexpr std::array<bool, 256> simple_table(Ambiguity ambiguity) {
  std::array<bool, 256> table{};
  for (unsigned set = 0; set < 256; ++set) {
    const unsigned rest = ~set & 0xFFU;
    table[set] = ambiguity == Ambiguity::kSolid ? components_8(set) == 1 && components_4(rest) == 1
                                                : components_4(set) == 1 && components_8(rest) == 1;
  }
  return table;
}

constexpr auto kSimpleSolid = simple_table(Ambiguity::kSolid);
constexpr auto kSimpleVoid = simple_table(Ambiguity::kVoid);

class Thinning {
 public:
  Thinning(const BitImage& region, const BitImage& kept, const DistanceField& depth,
           const ThinningOptions& options)
      : image_(region), kept_(kept), depth_(depth), options_(options), ends_(region.grid()) {}

  BitImage run() {
    for (int row = 0; row < image_.rows(); ++row) {
      for (int column = 0; column < image_.columns(); ++column) consider(column, row);
    }
    while (!queue_.empty()) {
      const auto [depth, row, column] = queue_.top();
      queue_.pop();
      wear(column, row);
    }
    return std::move(image_);
  }

 private:
  using Entry = std::tuple<double, int, int>;  // depth, row, column

  void consider(int column, int row) {
    if (!image_.at(column, row) || kept_.at(column, row) || ends_.at(column, row)) return;
    queue_.push({depth_.at(column, row), row, column});
  }

  void wear(int column, int row) {
    if (!image_.at(column, row) || ends_.at(column, row)) return;
    const Neighbourhood around = neighbourhood(image_, column, row);
    if (!is_simple(around, options_.ambiguity)) return;
    if (std::popcount(around) == 1 && depth_.at(column, row) >= options_.end_depth) {
      return ends_.set(column, row, true);
    }
    image_.set(column, row, false);
    for (const Offset& o : kAround) consider(column + o.x, row + o.y);
  }

  BitImage image_;
  const BitImage& kept_;
  const DistanceField& depth_;
  const ThinningOptions& options_;
  BitImage ends_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

Neighbourhood neighbourhood(const BitImage& image, int column, int row) {
  unsigned set = 0;
  for (unsigned i = 0; i < 8; ++i) {
    set |= image.at(column + kAround[i].x, row + kAround[i].y) ? 1U << i : 0U;
  }
  return static_cast<Neighbourhood>(set);
}

bool is_simple(Neighbourhood neighbours, Ambiguity ambiguity) {
  return ambiguity == Ambiguity::kSolid ? kSimpleSolid[neighbours] : kSimpleVoid[neighbours];
}

BitImage thinned(const BitImage& region, const BitImage& kept, const DistanceField& depth,
                 const ThinningOptions& options) {
  return Thinning(region, kept, depth, options).run();
}

}  // namespace slipstick
