// Any bytes are a contour, places and a tolerance; the fewest edges stay within it, by windows of
// any width.
#include <cstddef>
#include <cstdint>

#include "core/contour/trace.h"
#include "tests/support/image_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  slipstick::test::ByteReader bytes({data, size});
  const slipstick::BitImage image = slipstick::test::image_of(bytes);
  const auto options = slipstick::test::options_of(bytes, image.grid());
  slipstick::ContourSet contours = slipstick::trace(image, slipstick::Ambiguity::kSolid);
  slipstick::test::place_by(bytes, contours);
  slipstick::test::check_fewest(contours, options);
  return 0;
}
