#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slipstick {

/// A zip file of parts by name, each deflated.
[[nodiscard]] std::string zip_of(const std::vector<std::pair<std::string, std::string>>& parts);

/// A 3MF file whose root part is `model`, and whose other model parts are `others`, by name.
[[nodiscard]] std::string package_3mf(
    const std::string& model, const std::vector<std::pair<std::string, std::string>>& others = {});

}  // namespace slipstick
