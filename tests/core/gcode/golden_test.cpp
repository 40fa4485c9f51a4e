// The same text, byte for byte, on every machine: `scripts/arm64` runs this too.
#include <catch2/catch.hpp>

#include "core/contour/place_roots.h"
#include "core/contour/simplify.h"
#include "core/contour/trace.h"
#include "core/formats/lua_script.h"
#include "core/gcode/write.h"
#include "core/image/sample.h"
#include "core/job/placement.h"
#include "core/toolpath/plan_layer.h"
#include "tests/support/bit_hash.h"

using namespace slipstick;

namespace {

std::string text_of(const Solid& solid, int index, const PrintSettings& settings) {
  const double z = 0.1 + 0.2 * index;
  const Box3 box = solid.bounds();
  const auto section = solid.section(z);
  const auto grid = SliceGrid::over({{box.low.x, box.low.y}, {box.high.x, box.high.y}}, 0.1);
  const BitImage image = sample(*section, *grid).value();
  ContourSet contours = trace(image, Ambiguity::kSolid);
  place_roots(contours, *section);
  const Outline outline = simplify_fewest(contours, {}).outline;
  const BitImage nothing(image.grid());
  const LayerProgram program = write_layer(plan_layer({index, 0.2 * (index + 1), 0.2, image,
                                                       outline, index < 2 ? image : nothing, image},
                                                      settings),
                                           settings);
  return program.text;
}

}  // namespace

TEST_CASE("Layers of a turned solid are the same text on every machine", "[golden]") {
  const auto model = load_lua_model(
      "return union(box(20, 12, 3), cylinder(4, 8):rotate(20, 0, 0)):bounds(-20, -20, -9, 20, 20, "
      "9)",
      "golden.lua");
  REQUIRE(model);
  PlacementRequest request;
  request.rotate = {3, 5, 37};
  const auto placed = place_on_bed(**model, request, {60, 60});
  REQUIRE(placed);
  PrintSettings settings;
  settings.toolpath.infill_angle = 33;
  test::BitHash hash;
  for (int layer = 0; layer < 4; ++layer) hash.add(text_of(*placed->solid, layer, settings));
  CHECK(hash.value() == 0x11554c05266c2cd8u);
}
