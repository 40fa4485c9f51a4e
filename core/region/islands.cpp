#include "core/region/islands.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/contour/ledger_runs.h"

namespace slipstick {
namespace {

constexpr int kReachNodesMax = 128;

struct Node {
  int column = 0;
  int row = 0;
};

// The runs of an image, and which of them are one island.
class Islands {
 public:
  explicit Islands(const BitImage& image)
      : grid_(image.grid()), runs_(image, RunImage::Of::kInside), sets_(runs_.size()) {
    for (int row = 1; row < runs_.rows(); ++row) {
      each_touching({runs_, row}, {runs_, row - 1}, Touch::kCorners,
                    [this](std::size_t a, std::size_t b) { sets_.join(a, b); });
    }
  }

  [[nodiscard]] std::size_t size() const { return runs_.size(); }
  [[nodiscard]] std::size_t island(std::size_t run) { return sets_.find(run); }

  /// Calls `found` with the island of each run that shares a node with `other`.
  template <typename Found>
  void each_over(const BitImage& other, Found found) {
    const RunImage others(other, RunImage::Of::kInside);
    for (int row = 0; row < runs_.rows(); ++row) {
      each_touching({runs_, row}, {others, row}, Touch::kFaces,
                    [&](std::size_t run, std::size_t) { found(island(run)); });
    }
  }

  template <typename Wanted>
  [[nodiscard]] BitImage image_of(Wanted wanted) {
    BitImage image(grid_);
    for (int row = 0; row < runs_.rows(); ++row) {
      for (std::size_t run = runs_.begin(row); run < runs_.end(row); ++run) {
        const NodeRun nodes = runs_[run];
        if (wanted(island(run))) image.fill(nodes.first, row, nodes.last - nodes.first + 1, 1);
      }
    }
    return image;
  }

 private:
  const SliceGrid grid_;
  const RunImage runs_;
  DisjointSets sets_;
};

// The node of `image` that is inside and nearest to (x, y): of several the lowest, then leftmost.
std::optional<Node> nearest_inside(const BitImage& image, double x, double y) {
  const SliceGrid& grid = image.grid();
  const double column = (x - grid.node_x(0)) / grid.width();
  const double row = (y - grid.node_y(0)) / grid.width();
  const double reach = std::min(kIslandReach / grid.width(), double(kReachNodesMax));
  const double far = SliceGrid::kNodesMax;
  if (!(std::abs(column) <= far && std::abs(row) <= far)) return {};
  const int nodes = static_cast<int>(std::ceil(reach));
  const Node centre{static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row))};
  std::optional<Node> nearest;
  double least = reach * reach;
  for (int r = centre.row - nodes; r <= centre.row + nodes; ++r) {
    for (int c = centre.column - nodes; c <= centre.column + nodes; ++c) {
      const double away = (c - column) * (c - column) + (r - row) * (r - row);
      const bool is_nearer = nearest ? away < least : away <= least;
      if (!is_nearer || !image.at(c, r)) continue;
      nearest = Node{c, r};
      least = away;
    }
  }
  return nearest;
}

}  // namespace

BitImage island_at(const BitImage& image, double x, double y) {
  const auto node = nearest_inside(image, x, y);
  if (!node) return BitImage(image.grid());
  BitImage seed(image.grid());
  seed.set(node->column, node->row, true);
  Islands islands(image);
  std::size_t wanted = 0;
  islands.each_over(seed, [&](std::size_t island) { wanted = island; });
  return islands.image_of([wanted](std::size_t island) { return island == wanted; });
}

BitImage standing_on(const BitImage& image, const BitImage& below, const BitImage& cancelled) {
  if (!cancelled.any()) return BitImage(image.grid());
  Islands islands(image);
  std::vector<bool> over_cancelled(islands.size()), over_others(islands.size());
  islands.each_over(cancelled, [&](std::size_t island) { over_cancelled[island] = true; });
  islands.each_over(below - cancelled, [&](std::size_t island) { over_others[island] = true; });
  return islands.image_of(
      [&](std::size_t island) { return over_cancelled[island] && !over_others[island]; });
}

}  // namespace slipstick
