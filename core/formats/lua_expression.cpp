#include "core/formats/lua_expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/affine.h"
#include "core/formats/lua_script.h"

namespace slipstick {
namespace {

constexpr const char* kType = "slipstick.expression";
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box3 kEverywhere{{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};

Graph& graph_of(lua_State* lua) {
  Graph& graph = **static_cast<Graph**>(lua_getextraspace(lua));
  if (graph.size() > kLuaNodesMax)
    luaL_error(lua, "the expression has more than %d operations", static_cast<int>(kLuaNodesMax));
  return graph;
}

int push(lua_State* lua, Graph::Id id, const Box3& box) {
  void* memory = lua_newuserdatauv(lua, sizeof(LuaExpression), 0);
  new (memory) LuaExpression{id, box};
  luaL_setmetatable(lua, kType);
  return 1;
}

LuaExpression argument(lua_State* lua, int index) {
  if (const LuaExpression* e = lua_expression(lua, index)) return *e;
  if (lua_type(lua, index) == LUA_TNUMBER) {
    return {graph_of(lua).constant(lua_tonumber(lua, index)), kEverywhere};
  }
  luaL_error(lua, "arithmetic on a %s; expected an expression or a number",
             luaL_typename(lua, index));
  return {};
}

bool is_number(lua_State* lua, int index) {
  return lua_type(lua, index) == LUA_TNUMBER;
}

bool finite(const Box3& box) {
  return std::isfinite(length(box.high - box.low));
}

Box3 hull(const Box3& a, const Box3& b) {
  return a.with(b.low).with(b.high);
}

// The solid of min is the union, that of max the intersection; of other results nothing is known.
Box3 box_after(Op op, const Box3& a, const Box3& b) {
  if (op == Op::kMin) return a.empty() ? b : b.empty() ? a : hull(a, b);
  if (op == Op::kMax) return a.within(b);
  return kEverywhere;
}

template <Op op>
int lua_unary(lua_State* lua) {
  if (is_number(lua, 1)) {
    lua_pushnumber(lua, apply(op, lua_tonumber(lua, 1), 0));
    return 1;
  }
  const LuaExpression a = argument(lua, 1);
  return push(lua, graph_of(lua).unary(op, a.id), kEverywhere);
}

template <Op op>
int lua_binary(lua_State* lua) {
  if (is_number(lua, 1) && is_number(lua, 2)) {
    lua_pushnumber(lua, apply(op, lua_tonumber(lua, 1), lua_tonumber(lua, 2)));
    return 1;
  }
  const LuaExpression a = argument(lua, 1), b = argument(lua, 2);
  return push(lua, graph_of(lua).binary(op, a.id, b.id), box_after(op, a.box, b.box));
}

// min and max of one or more.
template <Op op>
int lua_fold(lua_State* lua) {
  const int count = lua_gettop(lua);
  if (count == 0) return luaL_error(lua, "min and max need an argument");
  for (int i = 1; i < count; ++i) {
    lua_pushcfunction(lua, lua_binary<op>);
    lua_pushvalue(lua, 1);
    lua_pushvalue(lua, i + 1);
    lua_call(lua, 2, 1);
    lua_replace(lua, 1);
  }
  lua_pushvalue(lua, 1);
  return 1;
}

// Whole powers by squaring, the square root, and a^b = exp(b ln a) for the rest.
int lua_power(lua_State* lua) {
  constexpr double kWholeMax = 64;
  const LuaExpression a = argument(lua, 1);
  Graph& graph = graph_of(lua);
  const double n = is_number(lua, 2) ? lua_tonumber(lua, 2) : 0.1;
  if (n == 0.5) return push(lua, graph.unary(Op::kSqrt, a.id), kEverywhere);
  if (n != std::floor(n) || std::abs(n) > kWholeMax) {
    const LuaExpression b = argument(lua, 2);
    const Graph::Id ln = graph.unary(Op::kLn, a.id);
    return push(lua, graph.unary(Op::kExp, graph.binary(Op::kMultiply, b.id, ln)), kEverywhere);
  }
  Graph::Id result = graph.constant(1), square = a.id;
  bool first = true;
  for (int rest = static_cast<int>(std::abs(n)); rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = first ? square : graph.binary(Op::kMultiply, result, square);
    if (rest % 2 == 1) first = false;
    if (rest > 1) square = graph.unary(Op::kSquare, square);
  }
  if (n < 0) result = graph.binary(Op::kDivide, graph.constant(1), result);
  return push(lua, result, kEverywhere);
}

Vec3 vec3(lua_State* lua, int first) {
  return {luaL_checknumber(lua, first), luaL_checknumber(lua, first + 1),
          luaL_checknumber(lua, first + 2)};
}

int transformed(lua_State* lua, const Affine3& map) {
  const LuaExpression a = argument(lua, 1);
  return push(lua, graph_of(lua).mapped(a.id, inverse(map)),
              finite(a.box) ? image_of(map, a.box) : kEverywhere);
}

int lua_moved(lua_State* lua) {
  return transformed(lua, translation(vec3(lua, 2)));
}
int lua_rotated(lua_State* lua) {
  return transformed(lua, rotation_degrees(vec3(lua, 2)));
}
int lua_scaled(lua_State* lua) {
  return transformed(lua, scaling(vec3(lua, 2)));
}

int lua_remapped(lua_State* lua) {
  const Graph::Id f = argument(lua, 1).id, u = argument(lua, 2).id, v = argument(lua, 3).id,
                  w = argument(lua, 4).id;
  return push(lua, graph_of(lua).substituted(f, u, v, w), kEverywhere);
}

int lua_bounded(lua_State* lua) {
  const LuaExpression a = argument(lua, 1);
  return push(lua, a.id, Box3{vec3(lua, 2), vec3(lua, 5)}.within(a.box));
}

// bounded(a) to the box of b.
int lua_boxed_as(lua_State* lua) {
  return push(lua, argument(lua, 1).id, argument(lua, 2).box);
}

// … grown by a margin.
int lua_boxed_around(lua_State* lua) {
  const LuaExpression a = argument(lua, 1), b = argument(lua, 2);
  const double m = luaL_checknumber(lua, 3);
  const Vec3 margin{m, m, m};
  return push(lua, a.id, {b.box.low - margin, b.box.high + margin});
}

int lua_box(lua_State* lua) {
  const Box3 box = argument(lua, 1).box;
  for (const double v : {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z}) {
    lua_pushnumber(lua, v);
  }
  return 6;
}

constexpr std::array<luaL_Reg, 9> kOperators{{{"__add", lua_binary<Op::kAdd>},
                                              {"__sub", lua_binary<Op::kSubtract>},
                                              {"__mul", lua_binary<Op::kMultiply>},
                                              {"__div", lua_binary<Op::kDivide>},
                                              {"__mod", lua_binary<Op::kModulo>},
                                              {"__pow", lua_power},
                                              {"__unm", lua_unary<Op::kNegate>},
                                              {nullptr, nullptr}}};

constexpr std::array<luaL_Reg, 18> kFunctions{{{"abs", lua_unary<Op::kAbs>},
                                               {"square", lua_unary<Op::kSquare>},
                                               {"sqrt", lua_unary<Op::kSqrt>},
                                               {"floor", lua_unary<Op::kFloor>},
                                               {"ceil", lua_unary<Op::kCeil>},
                                               {"sin", lua_unary<Op::kSin>},
                                               {"cos", lua_unary<Op::kCos>},
                                               {"tan", lua_unary<Op::kTan>},
                                               {"asin", lua_unary<Op::kAsin>},
                                               {"acos", lua_unary<Op::kAcos>},
                                               {"atan", lua_unary<Op::kAtan>},
                                               {"atan2", lua_binary<Op::kAtan2>},
                                               {"exp", lua_unary<Op::kExp>},
                                               {"ln", lua_unary<Op::kLn>},
                                               {"mod", lua_binary<Op::kModulo>},
                                               {"min", lua_fold<Op::kMin>},
                                               {"max", lua_fold<Op::kMax>},
                                               {nullptr, nullptr}}};

constexpr std::array<luaL_Reg, 9> kRaw{{{"moved", lua_moved},
                                        {"rotated", lua_rotated},
                                        {"scaled", lua_scaled},
                                        {"remapped", lua_remapped},
                                        {"bounded", lua_bounded},
                                        {"boxed_as", lua_boxed_as},
                                        {"boxed_around", lua_boxed_around},
                                        {"box", lua_box},
                                        {nullptr, nullptr}}};

}  // namespace

const LuaExpression* lua_expression(lua_State* lua, int index) {
  return static_cast<const LuaExpression*>(luaL_testudata(lua, index, kType));
}

void open_lua_expressions(lua_State* lua, Graph& graph) {
  *static_cast<Graph**>(lua_getextraspace(lua)) = &graph;
  luaL_newmetatable(lua, kType);
  luaL_setfuncs(lua, kOperators.data(), 0);
  lua_pushliteral(lua, "expression");
  lua_setfield(lua, -2, "__metatable");  // hides it from scripts
  lua_newtable(lua);                     // methods
  lua_pushvalue(lua, -1);
  lua_setfield(lua, -3, "__index");
  lua_newtable(lua);  // raw
  luaL_setfuncs(lua, kRaw.data(), 0);
  lua_pushvalue(lua, -2);
  lua_setfield(lua, -2, "methods");
  lua_setglobal(lua, "raw");
  lua_pop(lua, 2);
  lua_pushglobaltable(lua);
  luaL_setfuncs(lua, kFunctions.data(), 0);
  lua_pop(lua, 1);
  constexpr std::array<std::pair<Op, const char*>, 3> kVariables{
      {{Op::kX, "x"}, {Op::kY, "y"}, {Op::kZ, "z"}}};
  for (const auto& [op, name] : kVariables) {
    push(lua, graph.variable(op), kEverywhere);
    lua_setglobal(lua, name);
  }
}

}  // namespace slipstick
