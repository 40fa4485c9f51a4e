#include "core/job/settings_table_rows.h"

namespace slipstick {
namespace {

constexpr Setting kRows[] = {
    {"material_name", SettingGroup::kMaterial, "",
     NameSetting{[](auto& s) -> decltype(auto) { return (s.material.name); }},
     "What the filament is called in messages and G-code. Any name you like."},
    {"nozzle_celsius", SettingGroup::kMaterial, "°C",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.nozzle_celsius); }, 170, 320},
     "Nozzle from the second layer on. Begin in the middle of the range on the spool; print a "
     "temperature tower and take the coolest that bonds."},
    {"first_layer_nozzle_celsius", SettingGroup::kMaterial, "°C",
     NumberSetting{
         [](auto& s) -> decltype(auto) { return (s.material.first_layer_nozzle_celsius); }, 170,
         320},
     "Nozzle on the first layer. 5 to 10 above nozzle_celsius helps it stick."},
    {"bed_celsius", SettingGroup::kMaterial, "°C",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.bed_celsius); }, 0, 150},
     "Bed from the second layer on; 0 is off. Take it from the spool; raise it if corners lift."},
    {"first_layer_bed_celsius", SettingGroup::kMaterial, "°C",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.first_layer_bed_celsius); },
                   0, 150},
     "Bed on the first layer; 0 is off. As bed_celsius, or 5 more."},
    {"fan", SettingGroup::kMaterial, "",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.fan); }, 0, 1},
     "Share of full fan from the second layer on. 1 for PLA; lower it where layers split, raise it "
     "where overhangs sag."},
    {"flow", SettingGroup::kMaterial, "",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.flow); }, 0.5, 1.5},
     "Factor on all extrusion. Print a box of one perimeter, measure its wall and divide "
     "line_width by it."},
    {"density", SettingGroup::kMaterial, "g/cm³",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.density); }, 0.5, 10},
     "Weight of the filament for estimates. It is in the data sheet."},
    {"volume_speed_max", SettingGroup::kMaterial, "mm³/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.volume_speed_max); }, 0.5,
                   100},
     "Plastic that the hot end melts. Extrude ever faster into the air and stay a fifth below "
     "where the extruder clicks or the strand thins."},
    {"retraction", SettingGroup::kMaterial, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.retraction); }, 0, 15},
     "Filament pulled back before a travel; 0 is none. About 1 for a direct drive and 5 for a "
     "Bowden tube; raise it by halves until strings vanish."},
    {"retraction_speed", SettingGroup::kMaterial, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.retraction_speed); }, 1, 150},
     "Speed of retractions. 35 suits most; lower it if the extruder grinds the filament."},
    {"seconds_per_layer_min", SettingGroup::kMaterial, "s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.material.seconds_per_layer_min); }, 0,
                   300},
     "A layer that would take less is printed more slowly. Raise it if small tips melt."},
};

}  // namespace

std::span<const Setting> material_rows() {
  return kRows;
}

}  // namespace slipstick
