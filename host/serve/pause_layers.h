#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "host/serve/store.h"

namespace slipstick {

/// Of one job.
inline constexpr std::size_t kPausesMax = 100;

/// The layers before which a print is to be paused, as a client says them: an array of numbers from
/// 0. \return them in order, each once; kInput for anything else.
[[nodiscard]] Result<std::vector<int>> pause_layers(const nlohmann::json& json);

/// As `job` keeps them, in order.
[[nodiscard]] std::vector<int> pauses_of(const StoredJob& job);

}  // namespace slipstick
