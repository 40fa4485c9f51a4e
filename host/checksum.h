#pragma once

#include <cstdint>
#include <string_view>

namespace slipstick {

/// CRC-32, as of zlib.
[[nodiscard]] std::uint32_t checksum(std::string_view bytes);

}  // namespace slipstick
