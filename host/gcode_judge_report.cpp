#include "host/gcode_judge_report.h"

#include <fmt/format.h>

#include <numbers>

namespace slipstick {
namespace {

nlohmann::ordered_json topology_json(const Topology& t) {
  return {{"components", t.components}, {"tunnels", t.tunnels}, {"cavities", t.cavities}};
}

nlohmann::ordered_json defects_json(const std::vector<PrintDefect>& defects) {
  auto json = nlohmann::ordered_json::array();
  for (const PrintDefect& d : defects) {
    json.push_back({{"layer", d.layer},
                    {"z", d.z},
                    {"kind", describe(d.defect.kind)},
                    {"x", d.defect.place.x},
                    {"y", d.defect.place.y},
                    {"mm2", d.defect.mm2}});
  }
  return json;
}

nlohmann::ordered_json refusals_json(const GcodeVerdict& verdict) {
  auto first = nlohmann::ordered_json::array();
  for (const Refusal& r : verdict.refusals) {
    first.push_back({{"line", r.line}, {"text", r.text}, {"why", r.why}});
  }
  return {{"count", verdict.refused}, {"first", first}};
}

double grams(const GcodeVerdict& verdict, const PrintSettings& settings) {
  const double radius = settings.printer.filament_diameter / 2;
  constexpr double kMm3PerCm3 = 1000;
  return verdict.filament_mm * std::numbers::pi * radius * radius / kMm3PerCm3 *
         settings.material.density;
}

std::string topology_text(const Topology& t) {
  return fmt::format("{} components, {} tunnels, {} cavities", t.components, t.tunnels, t.cavities);
}

}  // namespace

nlohmann::ordered_json gcode_judge_report(const GcodeVerdict& verdict,
                                          const PrintSettings& settings) {
  const PrintVerdict& p = verdict.print;
  return {{"right", verdict.right()},
          {"print_seconds", verdict.seconds},
          {"filament_mm", verdict.filament_mm},
          {"grams", grams(verdict, settings)},
          {"moves", verdict.moves},
          {"travels", verdict.travels},
          {"retractions", verdict.retractions},
          {"deposit",
           {{"layers", p.layers},
            {"layers_unknown", p.layers_unknown},
            {"height_max", p.height_max},
            {"components_wrong", p.components_wrong},
            {"holes_wrong", p.holes_wrong},
            {"rims_bare", p.rims_bare},
            {"in_the_air", p.in_the_air},
            {"infill_missing", p.infill_missing},
            {"layers_missing", p.layers_missing},
            {"top_missing", verdict.top_missing},
            {"area_error", p.area_error_max},
            {"area_error_mean", p.area_error_mean},
            {"overhang_mm2", p.overhang_mm2},
            {"stray_mm2", p.stray_mm2}}},
          {"topology",
           {{"printed", topology_json(verdict.printed)}, {"model", topology_json(verdict.wanted)}}},
          {"refused", refusals_json(verdict)},
          {"defects", defects_json(p.defects)}};
}

std::string gcode_judge_text(const GcodeVerdict& verdict) {
  const PrintVerdict& p = verdict.print;
  std::string text;
  for (const PrintDefect& d : p.defects) {
    text += fmt::format("layer {} z={:.4g}: {} at {:.2f}, {:.2f}", d.layer, d.z,
                        describe(d.defect.kind), d.defect.place.x, d.defect.place.y);
    text += d.defect.mm2 > 0 ? fmt::format(" ({:.2f} mm²)\n", d.defect.mm2) : "\n";
  }
  if (verdict.top_missing > 0) {
    text += fmt::format("nothing is printed above z={:.4g}; the model is {:.4g} mm higher\n", p.top,
                        verdict.top_missing);
  }
  for (const Refusal& r : verdict.refusals) {
    text += fmt::format("line {}: {}: {}\n", r.line, r.why, r.text);
  }
  text += fmt::format(
      "{} layers: {} wrong components, {} wrong holes, {} bare rims, {} places in the air, {} "
      "without "
      "infill, {} left out\n",
      p.layers, p.components_wrong, p.holes_wrong, p.rims_bare, p.in_the_air, p.infill_missing,
      p.layers_missing);
  text += fmt::format("printed: {}\n  model: {}\n", topology_text(verdict.printed),
                      topology_text(verdict.wanted));
  text += fmt::format("{:.0f} s, {:.0f} mm of filament, {} moves, {} travels, {} retractions\n",
                      verdict.seconds, verdict.filament_mm, verdict.moves, verdict.travels,
                      verdict.retractions);
  return text;
}

}  // namespace slipstick
