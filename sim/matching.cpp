#include "sim/matching.h"

#include <algorithm>
#include <map>
#include <utility>

namespace slipstick {

namespace {

/// Pixels a side of the least hole that must stay open. Beads thinner than a pixel's diagonal are
/// drawn that wide, so two of them may cover a gap of two pixels between them.
constexpr int kTellableSide = 3;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// The values of each key, each once, in order.
std::map<int, std::vector<int>> grouped(std::vector<std::pair<int, int>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::map<int, std::vector<int>> result;
  for (const auto& [key, value] : pairs) result[key].push_back(value);
  return result;
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

}  // namespace

std::vector<Overlap> meetings(const Regions& wanted, const Regions& printed, std::int64_t speck) {
  const std::vector<Overlap> pairs = overlaps(wanted, printed);
  // The first of those that share most: a part of two pixels must not be cut by lying on a border.
  std::vector<const Overlap*> most(index(wanted.count()));
  for (const Overlap& pair : pairs) {
    const Overlap*& best = most[index(pair.a)];
    if (best == nullptr || pair.pixels > best->pixels) best = &pair;
  }
  std::vector<Overlap> result;
  for (const Overlap& pair : pairs) {
    if (pair.pixels >= speck || &pair == most[index(pair.a)]) result.push_back(pair);
  }
  return result;
}

std::vector<Split> find_cuts(const Wanted& wanted, const std::vector<Overlap>& met) {
  std::vector<std::pair<int, int>> printed_of, own_of;
  for (const Overlap& pair : met) {
    printed_of.emplace_back(wanted.parts.labels()[index(pair.a)], pair.b);
  }
  for (int part = 0; part < wanted.parts.count(); ++part) {
    own_of.emplace_back(wanted.parts.labels()[index(part)], part);
  }
  const auto own = grouped(std::move(own_of));
  std::vector<Split> cuts;
  for (const auto& [label, parts] : grouped(std::move(printed_of))) {
    const int extra = static_cast<int>(parts.size()) - static_cast<int>(own.at(label).size());
    if (extra > 0) cuts.push_back({label, parts, extra});
  }
  return cuts;
}

std::vector<Split> find_joints(const Wanted& wanted, const std::vector<Overlap>& met) {
  std::vector<int> raster_of(index(wanted.parts.count()));
  for (const Overlap& pair : overlaps(wanted.parts, wanted.raster)) {
    raster_of[index(pair.a)] = pair.b;
  }
  std::vector<std::pair<int, int>> labels_of, rasters_of;
  for (const Overlap& pair : met) {
    labels_of.emplace_back(pair.b, wanted.parts.labels()[index(pair.a)]);
    rasters_of.emplace_back(pair.b, raster_of[index(pair.a)]);
  }
  const auto rasters = grouped(std::move(rasters_of));
  std::vector<Split> joints;
  for (const auto& [part, labels] : grouped(std::move(labels_of))) {
    const int extra = static_cast<int>(std::min(labels.size(), rasters.at(part).size())) - 1;
    if (extra > 0) joints.push_back({part, labels, extra});
  }
  return joints;
}

int total(const std::vector<Split>& splits) {
  int sum = 0;
  for (const Split& split : splits) sum += split.count;
  return sum;
}

std::set<int> find_missing(const Wanted& material, const Regions& near) {
  std::set<int> missing(material.parts.labels().begin(), material.parts.labels().end());
  for (const Overlap& pair : overlaps(material.parts, near)) {
    missing.erase(material.parts.labels()[index(pair.a)]);
  }
  return missing;
}

std::set<int> find_closed(const Wanted& space, const Regions& printed_free) {
  std::set<int> closed = labels_with_square(space.parts, kTellableSide);
  for (const Overlap& pair : overlaps(space.parts, printed_free)) {
    closed.erase(space.parts.labels()[index(pair.a)]);
  }
  return closed;
}

}  // namespace slipstick
