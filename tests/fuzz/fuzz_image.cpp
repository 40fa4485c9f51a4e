// Any bytes are an image and places on its sticks; whatever the rule and the simplification, the
// audit finds nothing and every sample is on its side.
#include <cstddef>
#include <cstdint>

#include "tests/support/image_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  slipstick::test::ByteReader bytes({data, size});
  const slipstick::BitImage image = slipstick::test::image_of(bytes);
  slipstick::test::check_image(image, bytes);
  return 0;
}
