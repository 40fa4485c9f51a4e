#pragma once

#include "core/base/result.h"
#include "core/job/settings.h"

namespace slipstick {

/// Whether settings that are each in range also suit each other. \return kInput names the first
/// that does not, and its bound.
[[nodiscard]] Result<void> validate(const PrintSettings& settings);

}  // namespace slipstick
