#include "core/job/settings_table_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace slipstick {
namespace {

// A bead narrower than half the bore breaks off, one wider than this the nozzle's face cannot
// press.
constexpr double kNarrowestBead = 0.5;
constexpr double kWidestBead = 2.5;

struct Rule {
  std::string_view key;
  double value;
  double low;
  double high;
  std::string_view reason;
};

}  // namespace

Result<void> validate(const PrintSettings& settings) {
  const auto& [printer, material, slicing, toolpath] = settings;
  const double nozzle = printer.nozzle_diameter;
  const double low = kNarrowestBead * nozzle, high = kWidestBead * nozzle;
  constexpr std::string_view kWidth = "0.5 to 2.5 times nozzle_diameter";
  constexpr std::string_view kHeight = "no thicker than nozzle_diameter and line_width";
  constexpr std::string_view kSpeed = "no faster than speed_max";
  const Rule rules[] = {
      {"line_width", toolpath.line_width, low, high, kWidth},
      {"first_layer_line_width", toolpath.first_layer_line_width, low, high, kWidth},
      {"layer_height", slicing.layer_height, 0, std::min(nozzle, toolpath.line_width), kHeight},
      {"first_layer_height", slicing.first_layer_height, 0,
       std::min(nozzle, toolpath.first_layer_line_width), kHeight},
      {"perimeter_speed", toolpath.perimeter_speed, 0, printer.speed_max, kSpeed},
      {"outer_perimeter_speed", toolpath.outer_perimeter_speed, 0, printer.speed_max, kSpeed},
      {"infill_speed", toolpath.infill_speed, 0, printer.speed_max, kSpeed},
      {"skin_speed", toolpath.skin_speed, 0, printer.speed_max, kSpeed},
      {"first_layer_speed", toolpath.first_layer_speed, 0, printer.speed_max, kSpeed},
      {"travel_speed", toolpath.travel_speed, 0, printer.speed_max, kSpeed},
  };
  for (const Rule& rule : rules) {
    if (rule.value < rule.low || rule.value > rule.high) {
      return fail(ErrorCode::kInput,
                  fmt::format("{}: {:.10g} must be {}, here {:.6g} to {:.6g}", rule.key, rule.value,
                              rule.reason, rule.low, rule.high));
    }
  }
  return {};
}

}  // namespace slipstick
