// Any bytes are the body of a .ldni file or none, and any are a .lda file or none; what is read is
// written and read as it was, and is cut without harm.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/check.h"
#include "core/formats/lda_file.h"
#include "core/formats/ldni_file.h"
#include "core/formats/sealed.h"

using namespace slipstick;

namespace {

void use(const LdniModel& model) {
  const auto again = load_ldni_model(write_ldni(model.ldni()), "a.ldni");
  SLIPSTICK_CHECK(again && (*again)->ldni() == model.ldni());
  const Box3 box = model.bounds_under({});
  if (box.empty()) return;
  const Vec3 c = box.centre();
  const auto section = model.placed({})->section(c.z);
  (void)section->narrowed({{c.x, c.y}, {box.high.x, box.high.y}});
  std::uint8_t inside = 0;
  section->classify({&c.x, 1}, {&c.y, 1}, {&inside, 1});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Larger grids take their time, which finds nothing.
  constexpr unsigned char kResolutionMost = 64;
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  const std::string_view body(reinterpret_cast<const char*>(data), size);
  SLIPSTICK_CHECK(!load_ldni_model(body, "a.ldni"));  // a checksum is not hit by chance
  if (size < 4 || data[0] > kResolutionMost || data[1] + data[2] != 0) return 0;
  if (const auto model = load_ldni_model(seal({"SLIPLDN\n", 1}, body), "a.ldni")) use(**model);
  if (const auto model = load_lda_model(body, "a.lda")) use(**model);
  return 0;
}
