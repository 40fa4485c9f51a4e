#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/pixel_image.h"

namespace slipstick {

/// Pixels of one row next to each other, in [begin, end).
struct PixelRun {
  int row = 0;
  int begin = 0;
  int end = 0;
  int label = 0;   ///< What the run belongs to: runs of different labels are never together.
  int region = 0;  ///< Which connected component, from 0.
};

/// Which side of contours.
enum class Side : std::uint8_t { kSolid, kFree };

/// The connected components of an image or of what it leaves free.
class Regions {
 public:
  /// The set pixels; pixels that touch at a corner are together (8-connected).
  [[nodiscard]] static Regions of_set(const PixelImage& image);
  /// The others; only pixels that share a side are together (4-connected). What lies beyond the
  /// frame is not looked at: a frame has an empty ring.
  [[nodiscard]] static Regions of_free(const PixelImage& image);
  /// The pixels on one side of `loops`, which are simple, disjoint and nested. A label is an island
  /// or a hole, as the loops themselves say: l + 1 inside loop l and outside the loops in it, 0 the
  /// outside. So two holes stay two and an island stays one even where a gap or a neck is too
  /// narrow for a pixel; solid parts hang together at corners too, free ones by sides only.
  [[nodiscard]] static Regions of_contours(const PixelFrame& frame,
                                           const std::vector<std::vector<Vec2>>& loops, Side side);

  [[nodiscard]] int count() const { return count_; }
  /// The label of each region.
  [[nodiscard]] std::span<const int> labels() const { return labels_; }
  /// By row, left to right.
  [[nodiscard]] std::span<const PixelRun> runs() const { return runs_; }

 private:
  Regions() = default;
  void connect(int reach);

  std::vector<PixelRun> runs_;
  std::vector<int> labels_;
  int count_ = 0;
};

/// How many pixels region `a` of one image and region `b` of another have in common.
struct Overlap {
  int a = 0;
  int b = 0;
  std::int64_t pixels = 0;
};

/// All pairs that have a pixel in common, ordered by a, then b. \pre Both of one frame.
[[nodiscard]] std::vector<Overlap> overlaps(const Regions& a, const Regions& b);

}  // namespace slipstick
