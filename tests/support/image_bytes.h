#pragma once

#include <cstdint>
#include <span>

#include "core/contour/contour_set.h"
#include "core/contour/simplify.h"
#include "core/image/bit_image.h"

namespace slipstick::test {

/// Reads bytes one by one; what is missing is 0.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] std::uint8_t next() {
    if (at_ == bytes_.size()) return 0;
    return bytes_[at_++];
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

inline constexpr int kByteImageSideMax = 24;

/// An image of 1 to `kByteImageSideMax` nodes a side: two bytes of size, then a bit a node.
[[nodiscard]] BitImage image_of(ByteReader& bytes);

/// Puts every vertex anywhere on its stick, one byte each: near the ends, in the middle, between.
void place_by(ByteReader& bytes, ContourSet& contours);

/// A tolerance from 0 to about 8 cells and a clustering ratio from 1 to 16, one byte each.
[[nodiscard]] SimplifyOptions options_of(ByteReader& bytes, const SliceGrid& grid);

/// Fails a check if the audit finds anything in what `image` became.
void check_outline(const BitImage& image, const Simplified& simplified);

/// Traces `image` by both rules, places and simplifies by every method, and audits each result.
void check_image(const BitImage& image, ByteReader& bytes);

/// Fails a check unless `simplify_fewest` keeps its tolerance.
void check_fewest(const ContourSet& contours, const SimplifyOptions& options);

}  // namespace slipstick::test
