#include "tests/support/image_bytes.h"

#include <array>

#include "core/base/check.h"
#include "core/contour/audit.h"
#include "core/contour/trace.h"
#include "tests/support/images.h"
#include "tests/support/outlines.h"

namespace slipstick::test {

BitImage image_of(ByteReader& bytes) {
  const int columns = 1 + bytes.next() % kByteImageSideMax;
  const int rows = 1 + bytes.next() % kByteImageSideMax;
  BitImage image(small_grid(columns, rows));
  unsigned bits = 0;
  for (int i = 0; i < columns * rows; ++i) {
    if (i % 8 == 0) bits = bytes.next();
    // The window has two nodes of margin on each side.
    if ((bits >> (i % 8) & 1u) != 0) image.set(i % columns + 2, i / columns + 2, true);
  }
  return image;
}

void place_by(ByteReader& bytes, ContourSet& contours) {
  for (Place& place : contours.places()) {
    const std::int64_t b = bytes.next();
    // The lowest and highest quarter count single units from the ends, the others spread evenly.
    const std::int64_t k = b < 64    ? b
                           : b < 192 ? (b - 63) * 508
                                     : SliceGrid::kUnitsPerCell - 256 + b;
    place = Place::clamped(k);
  }
}

SimplifyOptions options_of(ByteReader& bytes, const SliceGrid& grid) {
  const double part = bytes.next() / 90.0;
  const double cells = part * part;
  return {cells * grid.width(), 1 + bytes.next() % 16};
}

void check_outline(const BitImage& image, const Simplified& simplified) {
  const auto loops = audit_loops_of(simplified.outline);
  SLIPSTICK_CHECK(audit_loops(loops).empty());
  SLIPSTICK_CHECK(audit_sticks(loops, image.grid().width()).empty());
  SLIPSTICK_CHECK(audit_samples(loops, image).empty());
}

void check_image(const BitImage& image, ByteReader& bytes) {
  for (const Ambiguity ambiguity : {Ambiguity::kSolid, Ambiguity::kVoid}) {
    ContourSet contours = trace(image, ambiguity);
    const SimplifyOptions options = options_of(bytes, image.grid());
    place_by(bytes, contours);
    check_outline(image, keep_all(contours));
    check_outline(image, simplify_vsa(contours, options));
    check_outline(image, simplify_greedy(contours, options));
    check_outline(image, simplify_fewest(contours, options));
  }
}

void check_fewest(const ContourSet& contours, const SimplifyOptions& options) {
  const Simplified fewest = simplify_fewest(contours, options);
  // A window is never shorter than one unit to each side of the contour's own place.
  SLIPSTICK_CHECK(fewest.max_deviation <= options.tolerance + contours.grid().unit());
  SLIPSTICK_CHECK(fewest.outline.edges() <= keep_all(contours).outline.edges());
}

}  // namespace slipstick::test
