#pragma once

#include <memory>
#include <string_view>

#include "core/base/result.h"
#include "core/solid/ldni_model.h"

namespace slipstick {

/// \file
/// `.lda`, as the program of Leung and Wang (DebbieLeung/LDNI-based-Solid-Modeling, 2019) writes
/// it, little endian: i32 resolution, f32 width, three f32 origin; then for axis x, y, z:
/// resolution² + 1 u32, where each ray's samples begin, then of all samples f32 x of the normals,
/// f32 y of them, and f32 depths, whose sign is that of the normal's z. Rays stand in the order of
/// `LdniRays`.

/// Samples that are at one depth when rounded to units are left out two by two: nothing is between.
/// \return kInput for damage of any kind; the message names the file.
[[nodiscard]] Result<std::unique_ptr<LdniModel>> load_lda_model(std::string_view bytes,
                                                                std::string_view name);

}  // namespace slipstick
