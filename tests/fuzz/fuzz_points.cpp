// Any bytes are points with normals or none, in every format; the first byte chooses it.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/check.h"
#include "core/formats/point_cloud.h"

using namespace slipstick;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array<std::string_view, 3> kKinds{"xyz", "pwn", "ply"};
  // NOLINTNEXTLINE: bytes are what a fuzzer has
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  (void)ply_is_point_cloud(bytes);
  const auto cloud = read_point_cloud(bytes, kKinds[data[0] % kKinds.size()]);
  if (!cloud) return 0;
  SLIPSTICK_CHECK(cloud->points.size() == cloud->normals.size());
  SLIPSTICK_CHECK(cloud->points.size() <= size);
  for (const Vec3 n : cloud->normals) SLIPSTICK_CHECK(std::abs(length(n) - 1) < 1e-9);
  return 0;
}
