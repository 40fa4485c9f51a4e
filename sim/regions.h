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
  int region = 0;  ///< Which connected component, from 0.
};

/// The connected components of an image or of what it leaves free.
class Regions {
 public:
  /// The set pixels; pixels that touch at a corner are together (8-connected).
  [[nodiscard]] static Regions of_set(const PixelImage& image);
  /// The others; only pixels that share a side are together (4-connected). What lies beyond the frame is
  /// not looked at: a frame has an empty ring.
  [[nodiscard]] static Regions of_free(const PixelImage& image);

  [[nodiscard]] int count() const { return count_; }
  /// By row, left to right.
  [[nodiscard]] std::span<const PixelRun> runs() const { return runs_; }

 private:
  Regions() = default;
  void connect(int reach);

  std::vector<PixelRun> runs_;
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
