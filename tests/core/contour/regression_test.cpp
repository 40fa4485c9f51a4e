// How many edges each method needs on three shapes, and how far they stray: figures that only a
// deliberate change may move.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/contour/place_roots.h"
#include "core/contour/place_smooth.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/formats/lua_script.h"
#include "core/image/sample.h"

using namespace slipstick;

namespace {

constexpr double kWidth = 0.125;
constexpr double kMargin = 0.01;  // a hundredth, of edges and of distances

struct Figures {
  double edges = 0;
  double deviation = 0;  // of the Fréchet bound, in cells
};

struct Line {
  const char* name;
  const char* script;
  std::size_t sticks;
  Figures fewest, one_candidate, greedy, paper;
};

const Line kLines[] = {
    {"circle",
     "return cylinder(20.03, 10)",
     1284,
     {73, 0.1},
     {108, 0.0970},
     {108, 0.0982},
     {136, 0.0764}},
    {"gyroid",
     "local k = 2 * math.pi / 9\n"
     "local g = sin(k * x) * cos(k * y) + sin(k * y) * cos(k * z) + sin(k * z) * cos(k * x)\n"
     "return max(g ^ 2 - 0.16, sqrt(x ^ 2 + y ^ 2) - 20):bounds(-21, -21, -5, 21, 21, 5)",
     7206,
     {955, 0.1},
     {1450, 0.0984},
     {1451, 0.0997},
     {1591, 0.2677}},
    {"turned square",
     "return box(30, 30, 10):rotate(0, 0, 17)",
     1196,
     {8, 1.33e-5},
     {8, 1.33e-5},
     {8, 1.33e-5},
     {130, 0.0567}},
};

Figures figures_of(const Simplified& s) {
  return {static_cast<double>(s.outline.edges()), s.max_deviation / kWidth};
}

void check(const char* method, const Figures& measured, const Figures& known) {
  INFO(method << ": " << measured.edges << ", " << measured.deviation);
  CHECK(measured.edges == Approx(known.edges).epsilon(kMargin));
  CHECK(measured.deviation == Approx(known.deviation).epsilon(kMargin));
}

}  // namespace

TEST_CASE("Edges and deviations are what they were") {
  for (const Line& line : kLines) {
    INFO(line.name);
    const auto model = load_lua_model(line.script, line.name);
    REQUIRE(model.has_value());
    const auto solid = (*model)->placed({});
    const Box3 b = solid->bounds();
    const auto grid = SliceGrid::over({{b.low.x, b.low.y}, {b.high.x, b.high.y}}, kWidth);
    const auto section = solid->section(0.3);
    ContourSet contours = trace(sample(*section, *grid).value(), Ambiguity::kSolid);
    SimplifyOptions options{0.1 * kWidth, 10};

    place_roots(contours, *section);
    CHECK(contours.sticks().size() == line.sticks);
    check("fewest", figures_of(simplify_fewest(contours, options)), line.fewest);
    check("greedy", figures_of(simplify_greedy(contours, options)), line.greedy);
    options.candidates = Candidates::kOne;
    check("one candidate", figures_of(simplify_fewest(contours, options)), line.one_candidate);
    place_sliding(contours);
    options.tolerance = 1e9;  // as the paper's test of distortion, which never binds
    check("paper", figures_of(simplify_vsa(contours, options)), line.paper);
  }
}
