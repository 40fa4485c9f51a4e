#include "sim/judge.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "sim/pixel_image.h"
#include "sim/regions.h"

namespace slipstick {

namespace {

Box2 area_of(std::span<const ExtrudedSegment> beads, const Contours& contours) {
  Box2 area;
  for (const ExtrudedSegment& bead : beads) {
    const Vec2 radius{bead.width / 2, bead.width / 2};
    for (const Vec2 end : {bead.a, bead.b}) area = area.with(end - radius).with(end + radius);
  }
  for (const auto& loop : contours) {
    for (const Vec2 p : loop) area = area.with(p);
  }
  return area;
}

/// Who meets whom (see the header), and how often each part does.
struct Meetings {
  std::vector<Overlap> pairs;
  std::vector<int> wanted_meets;   ///< For each part of S.
  std::vector<int> printed_meets;  ///< For each part of D.
};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Meetings meetings(const Regions& wanted, const Regions& printed, std::int64_t speck) {
  Meetings result;
  result.wanted_meets.resize(index(wanted.count()));
  result.printed_meets.resize(index(printed.count()));
  const std::vector<Overlap> pairs = overlaps(wanted, printed);
  std::vector<std::int64_t> most(index(wanted.count()));
  for (const Overlap& pair : pairs) {
    most[index(pair.a)] = std::max(most[index(pair.a)], pair.pixels);
  }
  for (const Overlap& pair : pairs) {
    if (pair.pixels < speck && pair.pixels < most[index(pair.a)]) continue;
    result.pairs.push_back(pair);
    ++result.wanted_meets[index(pair.a)];
    ++result.printed_meets[index(pair.b)];
  }
  return result;
}

/// Parts of either side without a partner of their own; parts of D that meet nothing are no business of ours.
int count_wrong(const Meetings& m) {
  int matched = 0;
  for (const Overlap& pair : m.pairs) {
    if (m.wanted_meets[index(pair.a)] == 1 && m.printed_meets[index(pair.b)] == 1) ++matched;
  }
  const auto meeting =
      std::count_if(m.printed_meets.begin(), m.printed_meets.end(), [](int n) { return n > 0; });
  return static_cast<int>(m.wanted_meets.size()) + static_cast<int>(meeting) - 2 * matched;
}

/// Takes the parts of `image` that meet nothing out of it.
void remove_strays(PixelImage& image, const Regions& parts, const Meetings& m) {
  for (const PixelRun& run : parts.runs()) {
    if (m.printed_meets[index(run.region)] == 0) image.clear(run.row, run.begin, run.end);
  }
}

std::int64_t unmet_pixels(const Regions& parts, const Meetings& m) {
  std::int64_t pixels = 0;
  for (const PixelRun& run : parts.runs()) {
    if (m.printed_meets[index(run.region)] == 0) pixels += run.end - run.begin;
  }
  return pixels;
}

}  // namespace

LayerVerdict judge_layer(std::span<const ExtrudedSegment> beads, const Contours& contours,
                         const JudgeOptions& options) {
  SLIPSTICK_CHECK(options.pixel > 0 && options.speck_mm2 > 0);
  const PixelFrame frame = PixelFrame::over(area_of(beads, contours), options.pixel);
  PixelImage solid(frame);
  solid.fill(contours);
  PixelImage deposit(frame);
  for (const ExtrudedSegment& bead : beads) deposit.draw_capsule(bead.a, bead.b, bead.width);

  const double pixel_mm2 = options.pixel * options.pixel;
  const auto speck = static_cast<std::int64_t>(std::ceil(options.speck_mm2 / pixel_mm2));
  const Regions wanted = Regions::of_set(solid);
  const Regions printed = Regions::of_set(deposit);
  const Meetings material = meetings(wanted, printed, speck);
  const std::int64_t stray = unmet_pixels(printed, material);
  if (stray > 0) remove_strays(deposit, printed, material);

  const Regions wanted_free = Regions::of_free(solid);
  const Regions printed_free = Regions::of_free(deposit);
  const Meetings space = meetings(wanted_free, printed_free, speck);

  const auto solid_pixels = static_cast<double>(solid.count());
  const auto outside_pixels = static_cast<double>(deposit.count_without(solid));
  return {.components = wanted.count(),
          .holes = wanted_free.count() - 1,
          .components_wrong = count_wrong(material),
          .holes_wrong = count_wrong(space),
          .solid_mm2 = solid_pixels * pixel_mm2,
          .area_error = solid_pixels > 0 ? outside_pixels / solid_pixels : 0,
          .void_mm2 = static_cast<double>(unmet_pixels(printed_free, space)) * pixel_mm2,
          .stray_mm2 = static_cast<double>(stray) * pixel_mm2};
}

}  // namespace slipstick
