#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/solid/bsp_model.h"

namespace slipstick {

/// \file
/// `.bsp`: the envelope of sealed.h with magic "SLIPBSP\n", version 1. Body: u64 number of nodes,
/// then for each: plane a b c d (four doubles; in front is a x + b y + c z + d > 0), front and back
/// child (u32 each: a later node, or 2^32 - 1 for outside, 2^32 - 2 for inside). Node 0 is the
/// root.

[[nodiscard]] std::string write_bsp(const BspTree& tree);

/// \return kInput for damage of any kind; the message names the file.
[[nodiscard]] Result<std::unique_ptr<BspModel>> load_bsp_model(std::string_view bytes,
                                                               std::string_view name);

}  // namespace slipstick
