#include "core/formats/lua_script.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace slipstick;
using Catch::Contains;

namespace {

bool inside(const std::string& script, Vec3 p) {
  const auto model = load_lua_model("return " + script, "test.lua");
  INFO(script);
  if (!model) FAIL(model.error().message);
  const auto section = (*model)->placed({})->section(p.z);
  std::uint8_t result = 2;
  section->classify({&p.x, 1}, {&p.y, 1}, {&result, 1});
  return result == 1;
}

// Whether the boundary crosses the segment from `in` to `out` within a hundredth of it about its
// middle.
void check_boundary(const std::string& script, Vec3 in, Vec3 out) {
  INFO(script);
  CHECK(inside(script, in + 0.49 * (out - in)));
  CHECK_FALSE(inside(script, in + 0.51 * (out - in)));
}

std::string refusal(const std::string& script) {
  const auto model = load_lua_model(script, "test.lua");
  REQUIRE_FALSE(model);
  CHECK(model.error().code == ErrorCode::kInput);
  return model.error().message;
}

}  // namespace

TEST_CASE("Primitives end where they say") {
  check_boundary("sphere(5)", {4, 0, 0}, {6, 0, 0});
  check_boundary("box(2, 4, 6)", {0, 1, 0}, {0, 3, 0});
  check_boundary("box(10, 10, 10, 2)", {4, 0, 0}, {6, 0, 0});
  check_boundary("cylinder(3, 8)", {0, 2, 0}, {0, 4, 0});
  check_boundary("cylinder(3, 8)", {0, 0, 3}, {0, 0, 5});
  check_boundary("cone(4, 2, 10)", {2, 0, 0}, {4, 0, 0});
  check_boundary("torus(10, 2)", {11, 0, 0}, {13, 0, 0});
  check_boundary("capsule(0, 0, -5, 0, 0, 5, 2)", {0, 0, 6}, {0, 0, 8});
  check_boundary("half_space(0, 0, 2, 3):bounds(-9, -9, -9, 9, 9, 9)", {0, 0, 2}, {0, 0, 4});
}

TEST_CASE("Transforms and set operations do what they are called") {
  check_boundary("sphere(1):move(5, 0, 0)", {5.5, 0, 0}, {6.5, 0, 0});
  check_boundary("box(10, 2, 2):rotate(0, 0, 90)", {0, 4, 0}, {0, 6, 0});
  check_boundary("sphere(1):scale(3)", {2, 0, 0}, {4, 0, 0});
  check_boundary("sphere(1):offset(2)", {2, 0, 0}, {4, 0, 0});
  CHECK(inside("sphere(1):move(5, 0, 0):mirror('x')", {-5, 0, 0}));
  CHECK(inside("sphere(1):array(5, 0, 0, 3, 1, 1)", {10, 0, 0}));
  CHECK_FALSE(inside("sphere(1):array(5, 0, 0, 3, 1, 1)", {15, 0, 0}));
  for (const double x : {-15.9, -14.1, 14.1, 15.9}) {
    CHECK(inside("sphere(1):move(-15, 0, 0):array(30, 0, 0, 2)", {x, 0, 0}));
  }
  CHECK_FALSE(inside("sphere(5):shell(1)", {3.9, 0, 0}));
  CHECK(inside("sphere(5):shell(1)", {4.1, 0, 0}));
  CHECK_FALSE(inside("difference(sphere(5), sphere(2))", {1, 0, 0}));
  CHECK(inside("union(sphere(1), sphere(1):move(9, 0, 0))", {9, 0, 0}));
  CHECK_FALSE(inside("intersection(sphere(2), sphere(2):move(3, 0, 0))", {-1, 0, 0}));
  CHECK(inside("smooth_union(2, sphere(1), sphere(1):move(2.2, 0, 0))", {1.1, 0, 0.2}));
}

TEST_CASE("A blend is the polynomial minimum of its width, whichever comes first") {
  constexpr double k = 2;
  for (int i = 0; i < 400; ++i) {
    const double a = -3 + 0.31 * (i % 20);
    const double b = -3 + 0.29 * (i / 20);
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    const double least = std::min(a, b) - h * h * k / 4;
    const double most = std::max(a, b) + h * h * k / 4;
    if (std::min(std::abs(least), std::abs(most)) < 1e-9) continue;
    for (const std::string both : {"x, y", "y, x"}) {
      INFO(both << " at " << a << ", " << b);
      CHECK(inside("smooth_union(2, " + both + "):bounds(-9, -9, -9, 9, 9, 9)", {a, b, 0}) ==
            (least < 0));
      CHECK(inside("smooth_intersection(2, " + both + "):bounds(-9, -9, -9, 9, 9, 9)", {a, b, 0}) ==
            (most < 0));
    }
  }
}

TEST_CASE("A blend with what is infinitely far away is the other") {
  for (const std::string both : {"x, 1 / abs(z)", "1 / abs(z), x"}) {
    const std::string script = "smooth_union(2, " + both + "):bounds(-9, -9, -9, 9, 9, 9)";
    CHECK(inside(script, {-1, 0, 0}));
    CHECK_FALSE(inside(script, {1, 0, 0}));
  }
}

TEST_CASE("Lattices have their period") {
  for (const std::string name : {"gyroid", "schwarz_p", "diamond", "lidinoid"}) {
    const std::string script = "intersection(box(90, 90, 90), " + name + "(10, 1))";
    for (int i = 0; i < 50; ++i) {
      const Vec3 p{0.37 * i, 0.11 * i, 0.23 * i};
      CHECK(inside(script, p) == inside(script, p + Vec3{10, -10, 10}));
    }
  }
}

TEST_CASE("Mistakes are told with their line") {
  CHECK_THAT(refusal("\nreturn sphere('a')"), Contains("test.lua:2:") && Contains("number"));
  CHECK_THAT(refusal("return sphere(0)"), Contains("test.lua:1:") && Contains("greater than 0"));
  CHECK_THAT(refusal("return sphere(0/0)"), Contains("must be a number"));
  CHECK_THAT(refusal("return union()"), Contains("test.lua:1:"));
  CHECK_THAT(refusal("return sphere(1):mirror('w')"), Contains("axis"));
  CHECK_THAT(refusal("return sphere(1) .. 'a'"), Contains("test.lua:1:"));
  CHECK_THAT(refusal(""), Contains("must return a solid"));
  CHECK_THAT(refusal("return 5"), Contains("number"));
  CHECK_THAT(refusal("return x + y"), Contains("bounds"));
  CHECK_THAT(refusal("return gyroid(10, 1)"), Contains("bounds"));
  CHECK_THAT(refusal("local function f() return f() + 1 end return f()"), Contains("stack"));
  CHECK_THAT(refusal("\x1bLua"), Contains("test.lua"));
}

TEST_CASE("Nothing of the machine is in reach") {
  for (const char* name : {"io", "os", "require", "load", "loadfile", "dofile", "debug", "pcall",
                           "coroutine", "collectgarbage", "setmetatable", "getmetatable", "raw",
                           "string.rep", "string.gsub", "math.random", "package"}) {
    INFO(name);
    CHECK_THAT(refusal(std::string("if ") + name + " == nil then error('absent') end"),
               Contains("absent"));
  }
}

TEST_CASE("Every shipped solid loads and is not empty") {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(SLIPSTICK_SOURCE_DIR "/configs/solids")) {
    if (entry.path().extension() != ".lua") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const auto model = load_lua_model(text.str(), entry.path().filename().string());
    INFO(entry.path());
    REQUIRE(model);
    CHECK_FALSE((*model)->bounds_under({}).empty());
    ++count;
  }
  CHECK(count >= 4);
}
