/// \file
/// Any text as a fault by name: what is one can be made, and is within its bounds.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/check.h"
#include "sim/faults/fault_names.h"

using namespace slipstick;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto spec = FaultSpec::parse({reinterpret_cast<const char*>(data), size});
  if (!spec) return 0;
  SLIPSTICK_CHECK(spec->number() >= 0);
  SLIPSTICK_CHECK(make_fault(*spec, 1) != nullptr);
  return 0;
}
