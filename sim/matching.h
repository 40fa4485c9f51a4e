#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "sim/regions.h"

namespace slipstick {

/// \file
/// Which islands or holes the printed parts make, and where the two do not match one to one
/// (judge.h).

/// What is wanted on one side of the contours, as pixels.
struct Wanted {
  Regions parts;  ///< Of islands or holes; one of them may be in several parts, but for that all is
                  ///< true.
  Regions raster;  ///< The same pixels, put together without regard to what they belong to.
};

/// One thing that is in several: `count` of them too many.
struct Split {
  int whole;
  std::vector<int> parts;
  int count;
};

/// Pairs of a wanted part and a printed one that meet (judge.h).
[[nodiscard]] std::vector<Overlap> meetings(const Regions& wanted, const Regions& printed,
                                            std::int64_t speck);

/// Islands or holes (labels) that meet more printed parts than they have parts themselves.
[[nodiscard]] std::vector<Split> find_cuts(const Wanted& wanted, const std::vector<Overlap>& met);

/// Printed parts that meet several islands or holes (labels) which do not touch in the raster
/// themselves.
[[nodiscard]] std::vector<Split> find_joints(const Wanted& wanted, const std::vector<Overlap>& met);

/// How many are too many in all.
[[nodiscard]] int total(const std::vector<Split>& splits);

/// Islands of which no pixel is near the printed parts.
[[nodiscard]] std::set<int> find_missing(const Wanted& material, const Regions& near);

/// Holes that are closed up, those too narrow to tell left out.
[[nodiscard]] std::set<int> find_closed(const Wanted& space, const Regions& printed_free);

}  // namespace slipstick
