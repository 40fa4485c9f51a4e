#pragma once

#include <span>
#include <string_view>

namespace slipstick {

/// A file of host/web, compiled in.
struct WebAsset {
  std::string_view name;
  std::string_view text;
};

[[nodiscard]] std::span<const WebAsset> web_assets();

}  // namespace slipstick
