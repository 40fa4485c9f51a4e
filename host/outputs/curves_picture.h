#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "sim/curves.h"

namespace slipstick {

/// Draws temperatures with their targets, and speeds, over time as `.svg` or `.png`.
/// \return kInput if the extension is another, or the machine was never seen.
[[nodiscard]] Result<void> draw_curves(const Curves& curves, const std::filesystem::path& path);

}  // namespace slipstick
