#pragma once

#include <vector>

#include "tests/bench/targets/table.h"

namespace slipstick::targets {

/// \file
/// The rows, by what they measure. Each measures itself; order does not matter, but memory comes
/// first, since it reads the peak of the process.

[[nodiscard]] std::vector<Row> memory_rows();
[[nodiscard]] std::vector<Row> layer_rows();
[[nodiscard]] std::vector<Row> image_rows();
[[nodiscard]] std::vector<Row> scaling_rows();
[[nodiscard]] std::vector<Row> edge_rows();
[[nodiscard]] std::vector<Row> error_rows();
[[nodiscard]] std::vector<Row> placement_rows();
[[nodiscard]] std::vector<Row> certificate_rows();
[[nodiscard]] std::vector<Row> fit_rows();
[[nodiscard]] std::vector<Row> simulation_rows();
[[nodiscard]] std::vector<Row> sender_rows();
[[nodiscard]] std::vector<Row> daemon_rows();

}  // namespace slipstick::targets
