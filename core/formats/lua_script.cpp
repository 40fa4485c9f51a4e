#include "core/formats/lua_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/formats/lua_expression.h"
#include "core/formats/lua_prelude.h"
#include "core/solid/expr_model.h"

namespace slipstick {
namespace {

constexpr int kHookPeriod = 10'000;  // instructions between looks at the clock

// What a state may still use. Lives as long as the state.
struct Budget {
  std::size_t memory = kLuaMemoryMax;
  long instructions = kLuaInstructionsMax;
};

void* allocate(void* budget_pointer, void* block, std::size_t old_size, std::size_t size) {
  auto& budget = *static_cast<Budget*>(budget_pointer);
  const std::size_t held = block == nullptr ? 0 : old_size;
  if (size == 0) {
    std::free(block);
    budget.memory += held;
    return nullptr;
  }
  if (size > held && size - held > budget.memory) return nullptr;
  void* moved = std::realloc(block, size);
  if (moved != nullptr) budget.memory = budget.memory + held - size;
  return moved;
}

void count_instructions(lua_State* lua, lua_Debug* where) {
  void* budget_pointer = nullptr;
  lua_getallocf(lua, &budget_pointer);
  auto& budget = *static_cast<Budget*>(budget_pointer);
  budget.instructions -= kHookPeriod;
  if (budget.instructions >= 0) return;
  lua_getinfo(lua, "Sl", where);
  lua_pushfstring(lua, "%s:%d: the script runs for too long (more than %d million instructions)",
                  where->short_src, where->currentline,
                  static_cast<int>(kLuaInstructionsMax / 1'000'000));
  lua_error(lua);
}

// Everything that could reach the machine, hide an error, run without being counted, or differ from
// run to run is left out: pcall would let a script outlive its limits, string patterns can take for
// ever between two instructions.
constexpr std::array<const char*, 10> kBase{"assert",   "error",  "ipairs",   "next",     "pairs",
                                            "rawequal", "select", "tonumber", "tostring", "type"};
constexpr std::array<const char*, 7> kString{"byte",  "char",  "format", "len",
                                             "lower", "upper", "sub"};
constexpr std::array<const char*, 5> kTable{"concat", "insert", "remove", "sort", "unpack"};
constexpr std::array<const char*, 2> kNoMath{"random", "randomseed"};

// A new table on the stack with the named fields of the table below it, which it replaces.
template <std::size_t N>
void keep_only(lua_State* lua, const std::array<const char*, N>& names) {
  lua_createtable(lua, 0, static_cast<int>(N));
  for (const char* name : names) {
    lua_getfield(lua, -2, name);
    lua_setfield(lua, -2, name);
  }
  lua_remove(lua, -2);
}

// Puts a library's table on the stack.
void open_library(lua_State* lua, const char* name, lua_CFunction open) {
  luaL_requiref(lua, name, open, 0);
}

void open_libraries(lua_State* lua) {
  luaL_requiref(lua, "_G", luaopen_base, 0);
  keep_only(lua, kBase);
  open_library(lua, "math", luaopen_math);
  for (const char* name : kNoMath) {
    lua_pushnil(lua);
    lua_setfield(lua, -2, name);
  }
  lua_setfield(lua, -2, "math");
  open_library(lua, "table", luaopen_table);
  keep_only(lua, kTable);
  lua_setfield(lua, -2, "table");
  open_library(lua, "string", luaopen_string);
  keep_only(lua, kString);
  // The methods of strings come from here too.
  lua_pushliteral(lua, "");
  lua_getmetatable(lua, -1);
  lua_pushvalue(lua, -3);
  lua_setfield(lua, -2, "__index");
  lua_pop(lua, 2);
  lua_setfield(lua, -2, "string");
  lua_rawseti(lua, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
}

struct Source {
  std::string_view text;
  const char* name;
};

void load(lua_State* lua, const Source& source) {
  if (luaL_loadbufferx(lua, source.text.data(), source.text.size(), source.name, "t") != LUA_OK) {
    lua_error(lua);
  }
}

// Calls the Lua function in its upvalue. A script that ends with `return sphere(0)` is gone from
// the stack by the time `sphere` complains, and its line with it; called from C, it stays.
int call_wrapped(lua_State* lua) {
  lua_pushvalue(lua, lua_upvalueindex(1));
  lua_insert(lua, 1);
  lua_call(lua, lua_gettop(lua) - 1, LUA_MULTRET);
  return lua_gettop(lua);
}

// Wraps the Lua functions of the table on top of the stack.
void wrap_functions(lua_State* lua) {
  for (lua_pushnil(lua); lua_next(lua, -2) != 0; lua_pop(lua, 1)) {
    if (!lua_isfunction(lua, -1) || lua_iscfunction(lua, -1)) continue;
    lua_pushvalue(lua, -2);
    lua_pushvalue(lua, -2);
    lua_pushcclosure(lua, call_wrapped, 1);
    lua_rawset(lua, -5);
  }
}

void wrap_prelude(lua_State* lua) {
  lua_pushglobaltable(lua);
  wrap_functions(lua);
  lua_getfield(lua, -1, "raw");
  lua_getfield(lua, -1, "methods");
  wrap_functions(lua);
  lua_pop(lua, 3);
}

// Runs in protected mode, with the script's `Source` as its only argument.
int run_script(lua_State* lua) {
  const Source script = *static_cast<const Source*>(lua_touserdata(lua, 1));
  Graph* graph = *static_cast<Graph**>(lua_getextraspace(lua));
  open_libraries(lua);
  open_lua_expressions(lua, *graph);
  load(lua, {lua_prelude(), "=prelude"});
  lua_call(lua, 0, 0);
  wrap_prelude(lua);
  lua_pushnil(lua);
  lua_setglobal(lua, "raw");
  load(lua, script);
  lua_call(lua, 0, 1);
  return 1;
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

class State {
 public:
  explicit State(Graph& graph) : lua_(lua_newstate(allocate, &budget_)) {
    if (lua_ == nullptr) return;
    *static_cast<Graph**>(lua_getextraspace(lua_)) = &graph;
    lua_sethook(lua_, count_instructions, LUA_MASKCOUNT, kHookPeriod);
  }
  ~State() {
    if (lua_ != nullptr) lua_close(lua_);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  // What the script returned, or why it did not.
  Result<LuaExpression> run(std::string_view text, std::string_view name) {
    const std::string chunk = fmt::format("={}", name);
    Source source{text, chunk.c_str()};
    lua_pushcfunction(lua_, run_script);
    lua_pushlightuserdata(lua_, &source);
    const int status = lua_pcall(lua_, 1, 1, 0);
    if (status == LUA_ERRMEM) {
      return refuse(name, "the script needs more than 256 MiB of memory");
    }
    if (status != LUA_OK) {
      const char* message = lua_tostring(lua_, -1);
      if (message != nullptr && !std::string_view(message).starts_with(name)) {
        return refuse(name, one_line(message));
      }
      return fail(ErrorCode::kInput,
                  one_line(message != nullptr ? message
                                              : fmt::format("{}: the script raised an error that "
                                                            "is no text",
                                                            name)));
    }
    const LuaExpression* expression = lua_expression(lua_, -1);
    if (expression == nullptr) {
      return refuse(name,
                    fmt::format("the script must return a solid, as in 'return sphere(20)'; it "
                                "returned {}",
                                luaL_typename(lua_, -1)));
    }
    return *expression;
  }

  [[nodiscard]] bool ok() const { return lua_ != nullptr; }

 private:
  static tl::unexpected<Error> refuse(std::string_view name, std::string_view why) {
    return fail(ErrorCode::kInput, fmt::format("{}: {}", name, why));
  }

  Budget budget_;
  lua_State* lua_;
};

}  // namespace

Result<std::unique_ptr<Model>> load_lua_model(std::string_view text, std::string_view name) {
  const auto refuse = [&](std::string_view why) {
    return fail(ErrorCode::kInput, fmt::format("{}: {}", name, why));
  };
  if (text.size() > kLuaBytesMax) return refuse("the script is larger than 4 MiB");
  Graph graph;
  State state(graph);
  if (!state.ok()) return fail(ErrorCode::kUnavailable, "out of memory");
  const auto solid = state.run(text, name);
  if (!solid) return fail(solid.error());
  const Box3& box = solid->box;
  if (box.empty()) return refuse("the solid is empty: its parts have nothing in common");
  if (!std::isfinite(length(box.size()))) {
    return refuse("the solid's extent is unknown; end with ':bounds(x0, y0, z0, x1, y1, z1)'");
  }
  return std::make_unique<ExprModel>(std::move(graph), solid->id, box);
}

}  // namespace slipstick
