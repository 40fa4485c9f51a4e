#include "sim/judge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "core/base/check.h"
#include "sim/coverage.h"
#include "sim/matching.h"
#include "sim/regions.h"
#include "sim/shortest_way.h"

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

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Whether each printed part meets anything.
std::vector<bool> is_met(const Regions& printed, const std::vector<Overlap>& met) {
  std::vector<bool> result(index(printed.count()));
  for (const Overlap& pair : met) result[index(pair.b)] = true;
  return result;
}

std::int64_t unmet_pixels(const Regions& parts, const std::vector<bool>& met) {
  std::int64_t pixels = 0;
  for (const PixelRun& run : parts.runs())
    pixels += met[index(run.region)] ? 0 : run.end - run.begin;
  return pixels;
}

void remove_unmet(PixelImage& image, const Regions& parts, const std::vector<bool>& met) {
  for (const PixelRun& run : parts.runs()) {
    if (!met[index(run.region)]) image.clear(run.row, run.begin, run.end);
  }
}

/// The parts that nothing meets, as an image.
PixelImage unmet(const Regions& parts, const std::vector<bool>& met, const PixelFrame& frame) {
  PixelImage image(frame);
  for (const PixelRun& run : parts.runs()) {
    if (!met[index(run.region)]) image.set(run.row, run.begin, run.end);
  }
  return image;
}

PixelImage drawn(const PixelFrame& frame, const Regions& regions) {
  PixelImage image(frame);
  for (const PixelRun& run : regions.runs()) image.set(run.row, run.begin, run.end);
  return image;
}

/// Loops inside an even number of others, as the audit of contours counts them.
int count_islands(const Contours& contours) {
  int islands = 0;
  for (const auto& loop : contours) {
    double doubled_area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      doubled_area += cross(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
    }
    islands += doubled_area > 0 ? 1 : 0;
  }
  return islands;
}

/// The runs for which `chosen` holds.
template <typename Chosen>
std::vector<PixelRun> runs_where(const Regions& regions, Chosen chosen) {
  std::vector<PixelRun> runs;
  std::copy_if(regions.runs().begin(), regions.runs().end(), std::back_inserter(runs), chosen);
  return runs;
}

/// Which of its numbers tells what part a run belongs to.
using PartOf = int PixelRun::*;

/// Where parts ought to hang together, or ought not to.
struct Ground {
  const PixelImage& pixels;
  Steps steps;
  const Regions& regions;
  PartOf part_of;
};

/// Puts each fault where a shortest way on the ground joins one part to a later one; where pixels
/// show no way, in the part itself.
void place_splits(const std::vector<Split>& splits, const Ground& ground, DefectKind kind,
                  std::vector<Defect>& defects) {
  int left = LayerVerdict::kDefectsPlaced;
  for (const Split& split : splits) {
    for (int i = 0; i < split.count && left > 0; ++i, --left) {
      const auto from = runs_where(ground.regions, [&](const PixelRun& run) {
        return run.*ground.part_of == split.parts[index(i)];
      });
      const auto to = runs_where(ground.regions, [&](const PixelRun& run) {
        return std::binary_search(split.parts.begin() + i + 1, split.parts.end(),
                                  run.*ground.part_of);
      });
      const auto middle = middle_of_shortest_way(ground.pixels, from, to, ground.steps);
      defects.push_back({kind, middle.value_or(middle_of_longest(ground.pixels.frame(), from)), 0});
    }
  }
}

/// Puts each missing island or closed hole into the middle of itself.
void place_lost(const std::set<int>& labels, const PixelFrame& frame, const Regions& parts,
                DefectKind kind, std::vector<Defect>& defects) {
  int left = LayerVerdict::kDefectsPlaced;
  for (const int label : labels) {
    if (left-- == 0) return;
    const auto runs = runs_where(parts, [&](const PixelRun& run) { return run.label == label; });
    defects.push_back({kind, middle_of_longest(frame, runs), 0});
  }
}

/// What was wanted and what was printed on one side: islands and material, or holes and free space.
struct Comparison {
  const Wanted& wanted;
  const Regions& printed;
  const std::vector<Overlap>& met;
  std::set<int> lost;  ///< Labels of which there is nothing.
  PixelImage wanted_pixels;
  PixelImage printed_pixels;
  Steps steps;
};

struct Kinds {
  DefectKind cut;
  DefectKind joined;
  DefectKind lost;
};

constexpr Kinds kComponents{DefectKind::kIslandCut, DefectKind::kIslandsJoined,
                            DefectKind::kIslandMissing};
constexpr Kinds kHoles{DefectKind::kHoleCut, DefectKind::kHolesJoined, DefectKind::kHoleClosed};

/// \return How many are wrong.
int find_wrong(const Comparison& c, const Kinds& kinds, std::vector<Defect>& defects) {
  const auto cuts = find_cuts(c.wanted, c.met);
  const auto joints = find_joints(c.wanted, c.met);
  place_splits(cuts, {c.wanted_pixels, c.steps, c.printed, &PixelRun::region}, kinds.cut, defects);
  place_splits(joints, {c.printed_pixels, c.steps, c.wanted.parts, &PixelRun::label}, kinds.joined,
               defects);
  place_lost(c.lost, c.wanted_pixels.frame(), c.wanted.parts, kinds.lost, defects);
  return total(cuts) + total(joints) + static_cast<int>(c.lost.size());
}

int pixels_of(double mm, double pixel) {
  return static_cast<int>(std::lround(mm / pixel));
}

void add(std::vector<Defect>& defects, const std::vector<Defect>& more) {
  defects.insert(defects.end(), more.begin(), more.end());
}

/// Pixels a side of the least bare or hanging place; odd.
int least_side(const JudgeOptions& options) {
  return 2 * (pixels_of(options.least_mm, options.pixel) / 2) + 1;
}

void judge_support(const Hanging& air, const JudgeOptions& options, LayerVerdict& verdict) {
  add(verdict.defects, thick_regions(air.wrong, least_side(options), DefectKind::kInTheAir));
  for (const Defect& d : thick_regions(air.wanted, least_side(options), DefectKind::kInTheAir)) {
    verdict.overhang_mm2 += d.mm2;
  }
}

/// What the perimeters left bare.
PixelImage bare_rim(const PixelImage& solid, const PixelImage& deposit,
                    const JudgeOptions& options) {
  PixelImage bare = rim_of(solid, pixels_of(options.rim_mm, options.pixel));
  return bare -= deposit;
}

}  // namespace

JudgedLayer judge_layer_over(const std::optional<PixelImage>& below,
                             std::span<const ExtrudedSegment> beads, const Contours& contours,
                             const JudgeOptions& options) {
  SLIPSTICK_CHECK(options.pixel > 0 && options.speck_mm2 > 0);
  const PixelFrame frame = PixelFrame::over(area_of(beads, contours), options.pixel);
  PixelImage deposit(frame);
  for (const ExtrudedSegment& bead : beads) deposit.draw_capsule(bead.a, bead.b, bead.width);
  const PixelImage laid = deposit;
  const double pixel_mm2 = options.pixel * options.pixel;
  const auto speck = static_cast<std::int64_t>(std::ceil(options.speck_mm2 / pixel_mm2));
  LayerVerdict verdict;

  Regions islands = Regions::of_contours(frame, contours, Side::kSolid);
  const PixelImage solid = drawn(frame, islands);
  if (below) {
    const int reach = pixels_of(options.reach_mm, options.pixel);
    judge_support(hanging(deposit, below->within(frame), solid, reach), options, verdict);
  }
  const Wanted material{std::move(islands), Regions::of_set(solid)};
  const Regions printed = Regions::of_set(deposit);
  const auto met = meetings(material.parts, printed, speck);
  const auto printed_met = is_met(printed, met);
  const std::int64_t stray = unmet_pixels(printed, printed_met);
  if (stray > 0) remove_unmet(deposit, printed, printed_met);

  const Wanted space{Regions::of_contours(frame, contours, Side::kFree), Regions::of_free(solid)};
  const Regions printed_free = Regions::of_free(deposit);
  const auto free_met = meetings(space.parts, printed_free, speck);
  const auto free_is_met = is_met(printed_free, free_met);

  const auto solid_pixels = static_cast<double>(solid.count());
  const auto outside_pixels = static_cast<double>(deposit.count_without(solid));
  const int island_count = count_islands(contours);
  verdict.components = island_count;
  verdict.holes = static_cast<int>(contours.size()) - island_count;
  verdict.components_wrong =
      find_wrong({material, printed, met, find_missing(material, Regions::of_set(deposit.grown())),
                  solid, deposit, Steps::kCorners},
                 kComponents, verdict.defects);
  verdict.holes_wrong = find_wrong({space, printed_free, free_met, find_closed(space, printed_free),
                                    solid.inverted(), deposit.inverted(), Steps::kSides},
                                   kHoles, verdict.defects);
  add(verdict.defects,
      thick_regions(bare_rim(solid, deposit, options), least_side(options), DefectKind::kRimBare));
  verdict.solid_mm2 = solid_pixels * pixel_mm2;
  verdict.area_error = solid_pixels > 0 ? outside_pixels / solid_pixels : 0;
  verdict.void_mm2 = static_cast<double>(unmet_pixels(printed_free, free_is_met)) * pixel_mm2;
  verdict.stray_mm2 = static_cast<double>(stray) * pixel_mm2;
  verdict.touches = !met.empty();

  const PixelImage voids = unmet(printed_free, free_is_met, frame);
  if (verdict.void_mm2 > 0) {
    const LargestSquare cell = largest_square(voids);
    verdict.void_side = cell.side * options.pixel;
    verdict.void_place = cell.middle;
  }
  PixelImage support = laid;
  support |= voids;
  deposit |= voids;
  return {std::move(verdict), solid, laid, std::move(deposit), std::move(support)};
}

LayerVerdict judge_layer(std::span<const ExtrudedSegment> beads, const Contours& contours,
                         const JudgeOptions& options) {
  return judge_layer_over(std::nullopt, beads, contours, options).verdict;
}

}  // namespace slipstick
