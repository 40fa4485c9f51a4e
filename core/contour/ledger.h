#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/contour/contour_set.h"
#include "core/contour/ledger_runs.h"
#include "core/image/bit_image.h"

namespace slipstick {

/// The Betti numbers of a solid.
struct Topology {
  std::int64_t components = 0;
  std::int64_t tunnels = 0;
  std::int64_t cavities = 0;  ///< Voids that nothing leads out of.

  friend bool operator==(const Topology&, const Topology&) = default;
};

/// The topology of a whole print, from its images one after the other: the solid is the union of
/// prisms, one for each node inside, from its layer's lower face to the upper.
///
/// One rule for all directions, the one contours are traced by: where ambiguous squares join the
/// solid, cells are closed, so those that share a corner, in the layer or with the next, hang
/// together, and the void hangs together through faces only; where they join the void, the other
/// way round. Components and cavities are counted by union-find between layers. Tunnels are
/// components + cavities - χ, where χ is the sum of the Euler numbers of the layers less those of
/// what neighbours have in common.
///
/// Memory: one image and its runs, whatever the number of layers.
class StackLedger {
 public:
  explicit StackLedger(Ambiguity ambiguity);

  /// The next layer, bottom to top. \pre All are on one grid.
  void add(const BitImage& image);

  /// Of the layers so far, the last one taken as the top.
  [[nodiscard]] Topology topology() const;

 private:
  // The components of one phase, solid or void: how many are complete, and those that reach the
  // last layer.
  class Phase {
   public:
    Phase(RunImage::Of what, Touch touch) : what_(what), touch_(touch) {}

    void add(const BitImage& image);
    [[nodiscard]] std::int64_t complete() const { return complete_; }
    [[nodiscard]] std::int64_t open() const { return static_cast<std::int64_t>(open_); }

   private:
    void join_within(const RunImage& runs, DisjointSets& sets) const;
    void join_below(const RunImage& runs, DisjointSets& sets) const;

    RunImage::Of what_;
    Touch touch_;
    std::optional<RunImage> below_;
    std::vector<std::size_t> component_;  // of each run below, 0 to open_ - 1
    std::size_t open_ = 0;
    std::int64_t complete_ = 0;
  };

  void add_to_phases(const BitImage& image);

  Touch touch_;
  Phase solid_;
  Phase void_;
  std::optional<BitImage> below_;
  std::int64_t euler_ = 0;
};

}  // namespace slipstick
