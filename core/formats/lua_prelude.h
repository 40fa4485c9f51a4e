#pragma once

#include <string_view>

namespace slipstick {

/// The part of the scripts' vocabulary that is itself written in Lua: primitives, TPMS, set
/// operations, blends and transforms, on top of what lua_expression.h provides.
[[nodiscard]] std::string_view lua_prelude();

}  // namespace slipstick
