// Solids that touch the lattice: f is 0 on nodes, or nearly, or all along a grid line. The image
// and the roots decide one way or the other; the contour has to be sound either way.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "core/contour/audit.h"
#include "core/contour/certify.h"
#include "core/contour/place_roots.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/formats/lua_script.h"
#include "core/image/sample.h"
#include "tests/support/flood.h"
#include "tests/support/outlines.h"

using namespace slipstick;

namespace {

// A power of two, so that the lattice holds the coordinates below exactly.
constexpr double kWidth = 0.125;

struct Traced {
  BitImage image;
  ContourSet contours;
  LayerCertificate certificate;
};

Traced traced(const std::string& script, Ambiguity ambiguity) {
  const auto model = load_lua_model(script, "tangency.lua");
  REQUIRE(model.has_value());
  const auto solid = (*model)->placed({});
  const Box3 b = solid->bounds();
  const auto grid = SliceGrid::over({{b.low.x, b.low.y}, {b.high.x, b.high.y}}, kWidth);
  REQUIRE(grid.has_value());
  REQUIRE(grid->width() == kWidth);
  const auto section = solid->section(0);
  const BitImage image = sample(*section, *grid).value();
  ContourSet contours = trace(image, ambiguity);
  place_roots(contours, *section);
  return {image, std::move(contours), certify_layer(*solid->field(), image, 0, 0)};
}

void check_sound(const Traced& t) {
  for (const double tolerance : {0.0, 0.0125, 1.0}) {
    const SimplifyOptions options{tolerance, 10};
    for (const Simplified& s :
         {keep_all(t.contours), simplify_fewest(t.contours, options),
          simplify_greedy(t.contours, options), simplify_vsa(t.contours, options)}) {
      const auto loops = test::audit_loops_of(s.outline);
      CHECK(audit_loops(loops).empty());
      CHECK(audit_sticks(loops, kWidth).empty());
      CHECK(audit_samples(loops, t.image).empty());
    }
  }
}

void check_sound(const std::string& script) {
  CAPTURE(script);
  check_sound(traced(script, Ambiguity::kSolid));
  check_sound(traced(script, Ambiguity::kVoid));
}

}  // namespace

TEST_CASE("A circle that touches grid lines, or nearly, has a sound contour of one loop") {
  for (const double off : {0.0, 1e-12, -1e-12, 1e-15, -1e-15, 1e-7, -1e-7}) {
    const std::string script =
        fmt::format("return sqrt(x^2 + y^2) - {:.17g}", 2 * (1 + off * kWidth));
    const std::string bounded = fmt::format("return ({}):bounds(-4, -4, -1, 4, 4, 1)",
                                            script.substr(std::string("return ").size()));

    check_sound(bounded);

    const Traced t = traced(bounded, Ambiguity::kSolid);
    CHECK(t.contours.loops().size() == 1);
  }
}

TEST_CASE("f = 0 on nodes is inside, and the contours are sound") {
  for (const char* f : {
           "max(abs(x), abs(y)) - 1",      // sides along grid lines
           "abs(x) + abs(y) - 1",          // through nodes, at 45 degrees
           "x * y",                        // two quadrants, touching in a node
           "(x - y) * (x + y)",            // the same, turned
           "min(max(x, y), max(-x, -y))",  // with creases
           "x^2 + y^2",                    // one node
           "x^2",                          // a line of nodes
           "0",                            // all of them
           "abs(x) - 0.125",               // a strip between grid lines
           "max(abs(abs(x) - 0.5), abs(abs(y) - 0.5)) - 0.125",
           "sin(8 * math.pi * x) * sin(8 * math.pi * y)",  // 0 at every node but for rounding
           "cos(8 * math.pi * x) + cos(8 * math.pi * y)",  // a checkerboard of nodes
       }) {
    check_sound(fmt::format("return ({} + 0 * x):bounds(-2, -2, -1, 2, 2, 1)", f));
  }
}

TEST_CASE("A corner that touches a node from outside is not certified as nothing") {
  // f is 0 at the node and positive elsewhere: the image shows a solid of one node.
  const Traced point = traced("return (x^2 + y^2):bounds(-2, -2, -1, 2, 2, 1)", Ambiguity::kSolid);

  CHECK(point.image.count() == 1);
  CHECK(test::components(point.image, 8) == 1);
  CHECK(point.certificate.uncertified > 0);
}

TEST_CASE("Where two solids meet in a node the saddle is not certified") {
  const Traced saddle = traced("return (x * y):bounds(-2, -2, -1, 2, 2, 1)", Ambiguity::kSolid);

  CHECK(saddle.certificate.uncertified > 0);
}
