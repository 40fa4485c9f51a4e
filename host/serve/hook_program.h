#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// Runs `program` with one argument and `input` on its standard input, and waits for it at most
/// `patience`; then it and its children are killed. \return kUnavailable unless it ends with status
/// 0.
[[nodiscard]] Result<void> run_program(const std::string& program, std::string_view argument,
                                       std::string_view input, std::chrono::milliseconds patience);

}  // namespace slipstick
