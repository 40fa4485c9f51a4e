#pragma once

#include <lua.hpp>

#include "core/base/box.h"
#include "core/expr/graph.h"

namespace slipstick {

/// \file
/// Expressions as Lua values: userdata with operators, and the functions the prelude builds upon.
///
/// Lua reports errors by longjmp, so nothing with a destructor may be alive in a function that can
/// fail.

/// An expression and the box its solid lies in; infinite where that is unknown.
struct LuaExpression {
  Graph::Id id = 0;
  Box3 box;
};

/// Makes `x`, `y`, `z`, arithmetic and the table `raw` known to scripts. `graph` outlives the
/// state.
void open_lua_expressions(lua_State* lua, Graph& graph);

/// The expression at `index`, or null if there is something else.
[[nodiscard]] const LuaExpression* lua_expression(lua_State* lua, int index);

}  // namespace slipstick
