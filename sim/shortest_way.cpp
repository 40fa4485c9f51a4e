#include "sim/shortest_way.h"

#include <array>
#include <cstdint>
#include <vector>

namespace slipstick {

namespace {

struct Step {
  int columns;
  int rows;
};

// The first four share a side.
constexpr std::array<Step, 8> kSteps{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// What is known of a pixel: kUnseen, kSource, or kSource + 1 + the step that led there.
constexpr std::uint8_t kUnseen = 0;
constexpr std::uint8_t kSource = 1;

class Search {
 public:
  Search(const PixelImage& ground, std::span<const PixelRun> from, std::span<const PixelRun> to)
      : ground_(ground),
        goal_(ground.frame()),
        seen_(static_cast<std::size_t>(ground.frame().columns) *
              static_cast<std::size_t>(ground.frame().rows)) {
    for (const PixelRun& run : to) goal_.set(run.row, run.begin, run.end);
    for (const PixelRun& run : from) {
      for (int c = run.begin; c < run.end; ++c) visit({c, run.row}, kSource);
    }
  }

  std::optional<Vec2> middle(std::size_t steps) {
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      const Pixel at = queue_[next];
      if (goal_.at(at.row, at.column)) return centre(half_back(at));
      for (std::size_t s = 0; s < steps; ++s) {
        visit({at.column + kSteps[s].columns, at.row + kSteps[s].rows},
              static_cast<std::uint8_t>(kSource + 1 + s));
      }
    }
    return std::nullopt;
  }

 private:
  struct Pixel {
    int column;
    int row;
  };

  std::uint8_t& seen(Pixel p) {
    return seen_[static_cast<std::size_t>(p.row) *
                     static_cast<std::size_t>(ground_.frame().columns) +
                 static_cast<std::size_t>(p.column)];
  }

  void visit(Pixel p, std::uint8_t how) {
    if (!ground_.at(p.row, p.column) || seen(p) != kUnseen) return;
    seen(p) = how;
    queue_.push_back(p);
  }

  bool go_back(Pixel& p) {
    if (seen(p) == kSource) return false;
    const Step step = kSteps[static_cast<std::size_t>(seen(p) - kSource - 1)];
    p = {p.column - step.columns, p.row - step.rows};
    return true;
  }

  Pixel half_back(Pixel end) {
    int steps = 0;
    for (Pixel p = end; go_back(p);) ++steps;
    for (int i = 0; i < steps / 2; ++i) go_back(end);
    return end;
  }

  [[nodiscard]] Vec2 centre(Pixel p) const { return ground_.frame().centre(p.column, p.row); }

  const PixelImage& ground_;
  PixelImage goal_;
  std::vector<std::uint8_t> seen_;
  std::vector<Pixel> queue_;
};

}  // namespace

std::optional<Vec2> middle_of_shortest_way(const PixelImage& ground, std::span<const PixelRun> from,
                                           std::span<const PixelRun> to, Steps steps) {
  return Search(ground, from, to).middle(steps == Steps::kCorners ? kSteps.size() : 4);
}

}  // namespace slipstick
