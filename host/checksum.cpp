#include "host/checksum.h"

#include <zlib.h>

namespace slipstick {

std::uint32_t checksum(std::string_view bytes) {
  // NOLINTNEXTLINE: zlib's bytes are unsigned
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(0, data, bytes.size()));
}

}  // namespace slipstick
