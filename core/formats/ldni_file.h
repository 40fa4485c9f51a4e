#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/solid/ldni_model.h"

namespace slipstick {

/// \file
/// `.ldni`: the envelope of sealed.h with magic "SLIPLDN\n", version 1. Body: u32 resolution,
/// doubles width and origin x y z, then, compressed by zlib, for axis x, y, z and each ray of it, i
/// running faster than j: the number of samples, then each sample's depth, as its distance from the
/// one before it (from 0 for the first), then each one's normal (u32 as `LdniNormal::word`).
/// Numbers and depths take 7 bits a byte, lowest first, the eighth bit set on all but the last.

[[nodiscard]] std::string write_ldni(const Ldni& ldni);

/// \return kInput for damage of any kind; the message names the file.
[[nodiscard]] Result<std::unique_ptr<LdniModel>> load_ldni_model(std::string_view bytes,
                                                                 std::string_view name);

}  // namespace slipstick
