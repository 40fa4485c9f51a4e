// Any bytes are the body of an .rbf file or none; what is read is written as it was, and its values
// agree with its inside.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/check.h"
#include "core/formats/rbf_file.h"
#include "core/formats/sealed.h"

using namespace slipstick;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  const std::string_view body(reinterpret_cast<const char*>(data), size);
  const std::string bytes = seal({"SLIPRBF\n", 1}, body);
  const auto model = load_rbf_model(bytes, "a.rbf");
  if (!model) return 0;
  SLIPSTICK_CHECK(write_rbf(**model) == bytes);
  const RbfModel& rbf = **model;
  const std::array<double, 1> x{rbf.functions()[0].centre.x}, y{rbf.functions()[0].centre.y};
  std::array<double, 1> value{};
  std::array<std::uint8_t, 1> inside{};
  const auto section = rbf.placed({})->section(rbf.functions()[0].centre.z);
  SLIPSTICK_CHECK(section->evaluate(x, y, value));
  section->classify(x, y, inside);
  SLIPSTICK_CHECK((value[0] <= 0) == (inside[0] != 0));
  return 0;
}
