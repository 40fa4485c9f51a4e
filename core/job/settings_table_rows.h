#pragma once

#include <span>

#include "core/job/settings_table.h"

namespace slipstick {

/// \file
/// The rows of the table, by group.

[[nodiscard]] std::span<const Setting> printer_rows();
[[nodiscard]] std::span<const Setting> material_rows();
[[nodiscard]] std::span<const Setting> slicing_rows();
[[nodiscard]] std::span<const Setting> toolpath_rows();

}  // namespace slipstick
