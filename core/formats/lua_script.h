#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "core/base/result.h"
#include "core/solid/solid.h"

namespace slipstick {

/// Limits of a script. It runs once, to build an expression, and is never called per sample.
inline constexpr std::size_t kLuaBytesMax = std::size_t{4} << 20;
inline constexpr std::size_t kLuaMemoryMax = std::size_t{256} << 20;
inline constexpr long kLuaInstructionsMax = 50'000'000;
inline constexpr std::size_t kLuaNodesMax = std::size_t{1} << 20;

/// Runs a Lua 5.4 script that returns a solid (configs/solids/README.md describes what it can use).
///
/// The script sees arithmetic, solids, and the harmless part of Lua's base, math, string and table
/// libraries: no files, processes, network, modules, code loading, coroutines or protected calls.
///
/// \return kInput, with `name` and line, if the script is broken, exceeds a limit, returns no
/// solid, or one
///   whose extent is unknown.
[[nodiscard]] Result<std::unique_ptr<Model>> load_lua_model(std::string_view text,
                                                            std::string_view name);

}  // namespace slipstick
