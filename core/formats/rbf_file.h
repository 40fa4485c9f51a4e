#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/solid/rbf_model.h"

namespace slipstick {

/// \file
/// `.rbf`: the envelope of sealed.h with magic "SLIPRBF\n", version 1. Body: u64 number of basis
/// functions, then for each 14 doubles: centre x y z, radius, ten coefficients in the order of
/// `RbfFunction::Quadric`, in the units of the points that were fitted.

[[nodiscard]] std::string write_rbf(const RbfModel& model);

/// \return kInput for damage of any kind; the message names the file.
[[nodiscard]] Result<std::unique_ptr<RbfModel>> load_rbf_model(std::string_view bytes,
                                                               std::string_view name);

}  // namespace slipstick
