#include "core/job/settings_table_rows.h"

namespace slipstick {
namespace {

constexpr std::string_view kBedShapes[] = {"rectangle", "round"};

constexpr Setting kRows[] = {
    {"printer_name", SettingGroup::kPrinter, "",
     NameSetting{[](auto& s) -> decltype(auto) { return (s.printer.name); }},
     "What the machine is called in messages and G-code. Any name you like."},
    {"bed_width", SettingGroup::kPrinter, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.bed_size.x); }, 20, 2000},
     "Printable size in X. It is in the data sheet; the firmware reports it to M115 or M211."},
    {"bed_depth", SettingGroup::kPrinter, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.bed_size.y); }, 20, 2000},
     "Printable size in Y. As bed_width."},
    {"bed_height", SettingGroup::kPrinter, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.bed_size.z); }, 20, 2000},
     "Printable height. As bed_width."},
    {"bed_shape", SettingGroup::kPrinter, "",
     ChoiceSetting{
         kBedShapes,
         [](const PrintSettings& s) { return static_cast<std::size_t>(s.printer.bed_shape); },
         [](PrintSettings& s, std::size_t i) { s.printer.bed_shape = static_cast<BedShape>(i); }},
     "A rectangle has its origin at the front left corner; round has it in the middle, as deltas "
     "do."},
    {"nozzle_diameter", SettingGroup::kPrinter, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.nozzle_diameter); }, 0.1, 2},
     "Bore of the nozzle. It is stamped on its side; most machines come with 0.4."},
    {"filament_diameter", SettingGroup::kPrinter, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.filament_diameter); }, 1, 3.5},
     "Measure the filament with calipers at five places and take the mean, about 1.75 or 2.85."},
    {"acceleration", SettingGroup::kPrinter, "mm/s²",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.acceleration); }, 50, 30000},
     "Acceleration while printing. Start from the firmware's M204 P in the answer to M503 and "
     "lower it if corners ring."},
    {"travel_acceleration", SettingGroup::kPrinter, "mm/s²",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.travel_acceleration); }, 50,
                   30000},
     "Acceleration of travels. Start from M204 T in the answer to M503 and lower it if layers "
     "shift."},
    {"speed_max", SettingGroup::kPrinter, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.speed_max); }, 10, 1000},
     "Fastest move in X and Y. Not above M203 X and Y in the answer to M503."},
    {"z_speed_max", SettingGroup::kPrinter, "mm/s",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.printer.z_speed_max); }, 0.5, 100},
     "Fastest move in Z. Not above M203 Z in the answer to M503."},
    {"baud", SettingGroup::kPrinter, "bit/s",
     IntegerSetting{[](auto& s) -> decltype(auto) { return (s.printer.baud); }, 9600, 2000000},
     "Speed of the serial port. It is in the board's manual or firmware, mostly 115200 or 250000; "
     "native USB ignores it."},
    {"window", SettingGroup::kPrinter, "bytes",
     IntegerSetting{[](auto& s) -> decltype(auto) { return (s.printer.window); }, 0, 120},
     "Moves that may be under way to the board at once, as bytes; 0 sends one line at a time, "
     "which "
     "survives any cable. 96 keeps slow ports full, on cables that lose nothing: a line damaged in "
     "a window may end the print."},
    {"start_gcode", SettingGroup::kPrinter, "",
     GcodeSetting{[](auto& s) -> decltype(auto) { return (s.printer.start_gcode); }},
     "Lines before the first layer; {bed_celsius} and {nozzle_celsius} are replaced. Take them "
     "from the maker's slicer profile, with G90 and M83."},
    {"end_gcode", SettingGroup::kPrinter, "",
     GcodeSetting{[](auto& s) -> decltype(auto) { return (s.printer.end_gcode); }},
     "Lines after the last layer. They must turn heaters, fan and motors off."},
};

}  // namespace

std::span<const Setting> printer_rows() {
  return kRows;
}

}  // namespace slipstick
