#include "sim/coverage.h"

#include <algorithm>

#include "core/base/check.h"

namespace slipstick {

namespace {

int length_of(const PixelRun& run) {
  return run.end - run.begin;
}

PixelImage grown_by(PixelImage image, int steps) {
  for (int i = 0; i < steps; ++i) image = image.grown();
  return image;
}

PixelImage shrunk_by(PixelImage image, int steps) {
  for (int i = 0; i < steps; ++i) image = image.shrunk();
  return image;
}

/// The runs of each region together.
std::vector<std::vector<PixelRun>> by_region(const Regions& regions) {
  std::vector<std::vector<PixelRun>> result(static_cast<std::size_t>(regions.count()));
  for (const PixelRun& run : regions.runs()) {
    result[static_cast<std::size_t>(run.region)].push_back(run);
  }
  return result;
}

/// The pieces of `image` no pixel of which is in `held`.
PixelImage unheld_pieces(const PixelImage& image, const PixelImage& held) {
  const Regions pieces = Regions::of_set(image);
  std::vector<bool> is_held(static_cast<std::size_t>(pieces.count()));
  for (const Overlap& pair : overlaps(pieces, Regions::of_set(held))) {
    is_held[static_cast<std::size_t>(pair.a)] = true;
  }
  PixelImage result(image.frame());
  for (const PixelRun& run : pieces.runs()) {
    if (!is_held[static_cast<std::size_t>(run.region)]) result.set(run.row, run.begin, run.end);
  }
  return result;
}

}  // namespace

Vec2 middle_of_longest(const PixelFrame& frame, std::span<const PixelRun> runs) {
  SLIPSTICK_CHECK(!runs.empty());
  const auto longest = std::max_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return length_of(a) < length_of(b);
  });
  return frame.centre((longest->begin + longest->end - 1) / 2, longest->row);
}

std::vector<Defect> thick_regions(const PixelImage& image, int side, DefectKind kind) {
  SLIPSTICK_CHECK(side % 2 == 1);
  const Regions regions = Regions::of_set(image);
  const Regions cores = Regions::of_set(shrunk_by(image, side / 2));
  const auto runs = by_region(regions);
  const auto core_runs = by_region(cores);
  const double pixel_mm2 = image.frame().size * image.frame().size;
  std::vector<Defect> found;
  int last = -1;
  for (const Overlap& pair : overlaps(regions, cores)) {
    if (pair.a == last) continue;
    last = pair.a;
    std::int64_t pixels = 0;
    for (const PixelRun& run : runs[static_cast<std::size_t>(pair.a)]) pixels += length_of(run);
    found.push_back({kind,
                     middle_of_longest(image.frame(), core_runs[static_cast<std::size_t>(pair.b)]),
                     static_cast<double>(pixels) * pixel_mm2});
  }
  return found;
}

/// By dynamic programming: the largest square that ends at a pixel is one more than the least of
/// those that end at its three neighbours before it.
LargestSquare largest_square(const PixelImage& image) {
  const PixelFrame& frame = image.frame();
  std::vector<int> above(static_cast<std::size_t>(frame.columns) + 1);
  std::vector<int> here(above.size());
  LargestSquare best;
  for (int row = 0; row < frame.rows; ++row) {
    for (std::size_t i = 1; i < here.size(); ++i) {
      const int column = static_cast<int>(i) - 1;
      here[i] = image.at(row, column) ? 1 + std::min({above[i], above[i - 1], here[i - 1]}) : 0;
      if (here[i] <= best.side) continue;
      const int back = here[i] / 2;
      best = {here[i], frame.centre(column - back, row - back)};
    }
    std::swap(above, here);
  }
  return best;
}

PixelImage rim_of(const PixelImage& solid, int depth) {
  PixelImage rim = solid;
  return rim -= shrunk_by(solid, depth);
}

Hanging hanging(const PixelImage& deposit, const PixelImage& support, const PixelImage& solid,
                int reach) {
  const PixelImage held = grown_by(support, reach);
  PixelImage over_nothing = deposit;
  over_nothing -= held;
  PixelImage wrong = over_nothing;
  wrong -= solid;
  wrong |= unheld_pieces(deposit, held);
  over_nothing -= wrong;
  return {std::move(wrong), std::move(over_nothing)};
}

}  // namespace slipstick
