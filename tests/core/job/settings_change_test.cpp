#include "core/job/settings_change.h"

#include <catch2/catch.hpp>
#include <set>

using namespace slipstick;
using Catch::Contains;

namespace {

std::string error_of(const SettingTexts& values) {
  const auto done = changed({}, values);
  REQUIRE_FALSE(done);
  CHECK(done.error().code == ErrorCode::kInput);
  return done.error().message;
}

}  // namespace

// A new setting has to be thought about: what do the layers below say to it?
TEST_CASE("These settings may change in the middle of a print, and no others") {
  const std::set<std::string_view> expected{"nozzle_celsius",
                                            "bed_celsius",
                                            "fan",
                                            "flow",
                                            "volume_speed_max",
                                            "retraction",
                                            "retraction_speed",
                                            "seconds_per_layer_min",
                                            "line_width",
                                            "perimeters",
                                            "top_layers",
                                            "bottom_layers",
                                            "infill_density",
                                            "infill_angle",
                                            "infill_overlap",
                                            "perimeter_speed",
                                            "outer_perimeter_speed",
                                            "infill_speed",
                                            "skin_speed",
                                            "travel_speed",
                                            "retract_travel_min",
                                            "seam_angle"};
  std::set<std::string_view> found;
  for (const SettingGroup group : kSettingGroups) {
    for (const Setting& setting : settings_of(group)) {
      if (why_settled(setting).empty()) found.insert(setting.key);
    }
  }

  CHECK(found == expected);
}

TEST_CASE("A change has all its values, and leaves the others alone") {
  PrintSettings before;
  before.toolpath.top_layers = 7;

  const auto after = changed(before, {{"infill_density", "0.4"}, {"nozzle_celsius", "215"}});

  REQUIRE(after);
  CHECK(after->toolpath.infill_density == 0.4);
  CHECK(after->material.nozzle_celsius == 215);
  CHECK(after->toolpath.top_layers == 7);
}

TEST_CASE("What cannot change is refused by its key, with the reason") {
  CHECK_THAT(error_of({{"sampling", "0.2"}}),
             Contains("sampling: cannot change in a print") && Contains("lattice"));
  CHECK_THAT(error_of({{"layer_height", "0.1"}}), Contains("layer_height"));
  CHECK_THAT(error_of({{"bed_width", "100"}}), Contains("bed_width") && Contains("machine"));
  CHECK_THAT(error_of({{"skirt_loops", "3"}}), Contains("first layer only"));
  CHECK_THAT(error_of({{"density", "1"}}), Contains("spool"));
}

TEST_CASE("Bad values are refused, and so is what does not suit the rest") {
  CHECK_THAT(error_of({}), Contains("no setting"));
  CHECK_THAT(error_of({{"infill", "0.4"}}), Contains("infill: unknown key"));
  CHECK_THAT(error_of({{"infill_density", "2"}}), Contains("infill_density: 2 is out of range"));
  CHECK_THAT(error_of({{"infill_density", "much"}}), Contains("must be a number"));
  CHECK_THAT(error_of({{"flow", "1." + std::string(1000, '0')}}), Contains("must be a number"));
  CHECK_THAT(error_of({{"line_width", "0.1"}}), Contains("line_width") && Contains("nozzle"));
  CHECK_THAT(error_of({{"infill_speed", "900"}}), Contains("no faster than speed_max"));
}
