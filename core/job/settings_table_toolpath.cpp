#include "core/job/settings_table_rows.h"

namespace slipstick {
namespace {

constexpr Setting kRows[] = {
    {"line_width", SettingGroup::kToolpath, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.line_width); }, 0.05, 5},
     "Width of a bead. 1.0 to 1.2 times the nozzle."},
    {"first_layer_line_width", SettingGroup::kToolpath, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.first_layer_line_width); },
                   0.05, 5},
     "Width of a bead on the first layer. As line_width; wider sticks better."},
    {"perimeters", SettingGroup::kToolpath, "",
     IntegerSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.perimeters); }, 1, 100},
     "Walls around each layer. 2; 3 or more for strength."},
    {"top_layers", SettingGroup::kToolpath, "",
     IntegerSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.top_layers); }, 0, 1000},
     "Solid layers below each upper face. Enough for 0.8 mm; more if the infill shows through."},
    {"bottom_layers", SettingGroup::kToolpath, "",
     IntegerSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.bottom_layers); }, 0, 1000},
     "Solid layers above each lower face. Enough for 0.6 mm."},
    {"infill_density", SettingGroup::kToolpath, "",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.infill_density); }, 0, 1},
     "Share of the inside that is filled. 0.15 holds tops up; 0.4 for load; 1 is solid."},
    {"infill_angle", SettingGroup::kToolpath, "°",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.infill_angle); }, -360, 360},
     "Direction of infill on even layers; odd ones are turned by 90. 45 loads X and Y motors "
     "alike."},
    {"infill_overlap", SettingGroup::kToolpath, "",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.infill_overlap); }, 0, 0.5},
     "Share of a line width by which infill enters the innermost perimeter. Raise it if they come "
     "apart."},
    {"skirt_loops", SettingGroup::kToolpath, "",
     IntegerSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.skirt_loops); }, 0, 50},
     "Loops around the print that get the nozzle going. 1; 0 for none."},
    {"skirt_distance", SettingGroup::kToolpath, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.skirt_distance); }, 0, 50},
     "From the print to the skirt. 4; so small that the skirt stays on the bed."},
    {"perimeter_speed", SettingGroup::kToolpath, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.perimeter_speed); }, 1, 1000},
     "Speed of inner perimeters. Lower it if walls ring or thin out."},
    {"outer_perimeter_speed", SettingGroup::kToolpath, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.outer_perimeter_speed); }, 1,
                   1000},
     "Speed of what is seen. Two thirds of perimeter_speed."},
    {"infill_speed", SettingGroup::kToolpath, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.infill_speed); }, 1, 1000},
     "Speed of sparse infill. As fast as volume_speed_max and the machine allow."},
    {"skin_speed", SettingGroup::kToolpath, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.skin_speed); }, 1, 1000},
     "Speed of solid layers. Lower it if tops are rough."},
    {"first_layer_speed", SettingGroup::kToolpath, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.first_layer_speed); }, 1,
                   1000},
     "Speed of the first layer. 20; lower it if it does not stick."},
    {"travel_speed", SettingGroup::kToolpath, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.travel_speed); }, 1, 1000},
     "Speed without extruding. Up to speed_max; lower it if layers shift."},
    {"retract_travel_min", SettingGroup::kToolpath, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.retract_travel_min); }, 0,
                   100},
     "Shorter travels do not retract. Raise it if the filament is ground, lower it if there are "
     "strings."},
    {"seam_angle", SettingGroup::kToolpath, "°",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.toolpath.seam_angle); }, -360, 360},
     "Where on the part seams gather: 0 is the right, 90 the rear. Turn it away from the side that "
     "is seen."},
};

}  // namespace

std::span<const Setting> toolpath_rows() {
  return kRows;
}

}  // namespace slipstick
