#pragma once

#include <string>

#include "core/base/result.h"

namespace slipstick {

/// Posts `json` to `url`, http or https, by libcurl, which nobody else includes. Waits for the
/// reply at most `kHookSeconds`; its body is not read. \return kUnavailable unless it is 2xx.
[[nodiscard]] Result<void> post_json(const std::string& url, const std::string& json);

}  // namespace slipstick
