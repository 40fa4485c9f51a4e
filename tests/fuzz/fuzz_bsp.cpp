// Any bytes are the body of a .bsp file or none, and what is read is written as it was.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/check.h"
#include "core/formats/bsp_file.h"
#include "core/formats/sealed.h"

using namespace slipstick;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  const std::string_view body(reinterpret_cast<const char*>(data), size);
  SLIPSTICK_CHECK(!load_bsp_model(body, "a.bsp"));  // a checksum is not hit by chance
  const std::string bytes = seal({"SLIPBSP\n", 1}, body);
  const auto model = load_bsp_model(bytes, "a.bsp");
  if (!model) return 0;
  SLIPSTICK_CHECK(write_bsp((*model)->tree()) == bytes);
  const Box3 box = (*model)->bounds_under({});
  if (!box.empty()) (void)(*model)->placed({})->section(box.centre().z)->narrowed({{0, 0}, {1, 1}});
  return 0;
}
