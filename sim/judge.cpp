#include "sim/judge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/check.h"
#include "sim/pixel_image.h"
#include "sim/regions.h"

namespace slipstick {

namespace {

/// Pixels a side of the least hole that must stay open. Beads thinner than a pixel's diagonal are
/// drawn that wide, so two of them may cover a gap of two pixels between them.
constexpr int kTellableSide = 3;

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

/// What is wanted on one side of the contours, as pixels.
struct Wanted {
  Regions parts;  ///< Of islands or holes; one of them may be in several parts, but for that all is
                  ///< true.
  Regions raster;  ///< The same pixels, put together without regard to what they belong to.
};

/// Pairs of a wanted part and a printed one that meet (see the header).
std::vector<Overlap> meetings(const Regions& wanted, const Regions& printed, std::int64_t speck) {
  const std::vector<Overlap> pairs = overlaps(wanted, printed);
  std::vector<std::int64_t> most(index(wanted.count()));
  for (const Overlap& pair : pairs) {
    most[index(pair.a)] = std::max(most[index(pair.a)], pair.pixels);
  }
  std::vector<Overlap> result;
  for (const Overlap& pair : pairs) {
    if (pair.pixels >= speck || pair.pixels == most[index(pair.a)]) result.push_back(pair);
  }
  return result;
}

/// How many pairs (key, value) there are of each key, each pair counted once.
std::map<int, int> counts(std::vector<std::pair<int, int>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::map<int, int> result;
  for (const auto& [key, value] : pairs) ++result[key];
  return result;
}

/// Islands or holes that meet more printed parts than they have parts themselves.
int count_cuts(const Wanted& wanted, const std::vector<Overlap>& met) {
  std::vector<std::pair<int, int>> printed_of, own_of;
  for (const Overlap& pair : met) {
    printed_of.emplace_back(wanted.parts.labels()[index(pair.a)], pair.b);
  }
  for (int part = 0; part < wanted.parts.count(); ++part) {
    own_of.emplace_back(wanted.parts.labels()[index(part)], part);
  }
  const std::map<int, int> own = counts(std::move(own_of));
  int cuts = 0;
  for (const auto& [label, parts] : counts(std::move(printed_of))) {
    cuts += std::max(0, parts - own.at(label));
  }
  return cuts;
}

/// Printed parts that meet several islands or holes which do not touch in the raster themselves.
int count_joints(const Wanted& wanted, const std::vector<Overlap>& met) {
  std::vector<int> raster_of(index(wanted.parts.count()));
  for (const Overlap& pair : overlaps(wanted.parts, wanted.raster)) {
    raster_of[index(pair.a)] = pair.b;
  }
  std::vector<std::pair<int, int>> labels_of, rasters_of;
  for (const Overlap& pair : met) {
    labels_of.emplace_back(pair.b, wanted.parts.labels()[index(pair.a)]);
    rasters_of.emplace_back(pair.b, raster_of[index(pair.a)]);
  }
  const std::map<int, int> rasters = counts(std::move(rasters_of));
  int joints = 0;
  for (const auto& [part, labels] : counts(std::move(labels_of))) {
    joints += std::min(labels, rasters.at(part)) - 1;
  }
  return joints;
}

/// Islands of which no pixel is near the printed parts.
int count_missing(const Wanted& material, const Regions& near) {
  std::set<int> missing(material.parts.labels().begin(), material.parts.labels().end());
  for (const Overlap& pair : overlaps(material.parts, near)) {
    missing.erase(material.parts.labels()[index(pair.a)]);
  }
  return static_cast<int>(missing.size());
}

/// What two runs have in common, of one label; empty if they are of two.
PixelRun common_part(const PixelRun& a, const PixelRun& b) {
  return {a.row, std::max(a.begin, b.begin), a.label == b.label ? std::min(a.end, b.end) : 0,
          a.label, 0};
}

/// Labels that have a square of `side` pixels somewhere.
std::set<int> labels_with_square(const Regions& parts, int side) {
  std::set<int> labels;
  const auto runs = parts.runs();
  std::vector<std::vector<PixelRun>> by_row;
  for (const PixelRun& run : runs) {
    by_row.resize(std::max(by_row.size(), index(run.row) + 1));
    by_row[index(run.row)].push_back(run);
  }
  for (std::size_t last = index(side) - 1; last < by_row.size(); ++last) {
    std::vector<PixelRun> columns = by_row[last];  // common to all rows looked at so far
    for (std::size_t up = 1; up < index(side); ++up) {
      std::vector<PixelRun> narrowed;
      for (const PixelRun& a : columns) {
        for (const PixelRun& b : by_row[last - up]) {
          const PixelRun c = common_part(a, b);
          if (c.end - c.begin >= side) narrowed.push_back(c);
        }
      }
      columns = std::move(narrowed);
    }
    for (const PixelRun& run : columns) labels.insert(run.label);
  }
  return labels;
}

/// Holes that are closed up, those too narrow to tell left out.
int count_closed(const Wanted& space, const Regions& printed_free) {
  std::set<int> closed = labels_with_square(space.parts, kTellableSide);
  for (const Overlap& pair : overlaps(space.parts, printed_free)) {
    closed.erase(space.parts.labels()[index(pair.a)]);
  }
  return static_cast<int>(closed.size());
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

}  // namespace

LayerVerdict judge_layer(std::span<const ExtrudedSegment> beads, const Contours& contours,
                         const JudgeOptions& options) {
  SLIPSTICK_CHECK(options.pixel > 0 && options.speck_mm2 > 0);
  const PixelFrame frame = PixelFrame::over(area_of(beads, contours), options.pixel);
  PixelImage deposit(frame);
  for (const ExtrudedSegment& bead : beads) deposit.draw_capsule(bead.a, bead.b, bead.width);
  const double pixel_mm2 = options.pixel * options.pixel;
  const auto speck = static_cast<std::int64_t>(std::ceil(options.speck_mm2 / pixel_mm2));

  Regions islands = Regions::of_contours(frame, contours, Side::kSolid);
  const PixelImage solid = drawn(frame, islands);
  const Wanted material{std::move(islands), Regions::of_set(solid)};
  const Regions printed = Regions::of_set(deposit);
  const auto met = meetings(material.parts, printed, speck);
  const auto printed_met = is_met(printed, met);
  const std::int64_t stray = unmet_pixels(printed, printed_met);
  if (stray > 0) remove_unmet(deposit, printed, printed_met);

  const Wanted space{Regions::of_contours(frame, contours, Side::kFree), Regions::of_free(solid)};
  const Regions printed_free = Regions::of_free(deposit);
  const auto free_met = meetings(space.parts, printed_free, speck);

  const auto solid_pixels = static_cast<double>(solid.count());
  const auto outside_pixels = static_cast<double>(deposit.count_without(solid));
  const int island_count = count_islands(contours);
  return {
      .components = island_count,
      .holes = static_cast<int>(contours.size()) - island_count,
      .components_wrong = count_cuts(material, met) + count_joints(material, met) +
                          count_missing(material, Regions::of_set(deposit.grown())),
      .holes_wrong = count_cuts(space, free_met) + count_joints(space, free_met) +
                     count_closed(space, printed_free),
      .solid_mm2 = solid_pixels * pixel_mm2,
      .area_error = solid_pixels > 0 ? outside_pixels / solid_pixels : 0,
      .void_mm2 = static_cast<double>(unmet_pixels(printed_free, is_met(printed_free, free_met))) *
                  pixel_mm2,
      .stray_mm2 = static_cast<double>(stray) * pixel_mm2};
}

}  // namespace slipstick
