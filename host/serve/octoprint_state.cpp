#include "host/serve/octoprint_state.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

Json heater(const HeaterReading& reading) {
  return {{"actual", std::isfinite(reading.celsius) ? Json(reading.celsius) : Json()},
          {"target", reading.target.value_or(0)},
          {"offset", 0}};
}

Json flags(PrinterActivity activity) {
  const bool stopped = activity == PrinterActivity::kStopped;
  return {{"operational", !stopped},
          {"printing", activity == PrinterActivity::kPrinting},
          {"paused", activity == PrinterActivity::kPaused},
          {"pausing", false},
          {"resuming", false},
          {"finishing", false},
          {"cancelling", activity == PrinterActivity::kEnding},
          {"sdReady", false},
          {"error", stopped},
          {"ready", activity == PrinterActivity::kIdle},
          {"closedOrError", stopped}};
}

}  // namespace

std::string_view octo_state(PrinterActivity activity) {
  constexpr std::array<std::string_view, 5> kTexts{"Operational", "Printing", "Paused",
                                                   "Cancelling", "Error"};
  return kTexts[static_cast<std::size_t>(activity)];
}

Json octo_state_of(PrinterActivity activity) {
  return {{"text", octo_state(activity)}, {"flags", flags(activity)}};
}

Json octo_temperatures(const std::optional<Temperatures>& seen) {
  Json json = Json::object();
  if (seen && seen->hotend) json["tool0"] = heater(*seen->hotend);
  if (seen && seen->bed) json["bed"] = heater(*seen->bed);
  return json;
}

Json octo_job_of(const OctoMoment& moment) {
  const Json name = moment.name.empty() ? Json() : Json(moment.name);
  return {{"file",
           {{"name", name},
            {"display", name},
            {"path", name},
            {"origin", moment.name.empty() ? Json() : Json("local")},
            {"size", moment.file ? Json(moment.file->size) : Json()},
            {"date", moment.file ? Json(moment.file->created) : Json()}}},
          {"estimatedPrintTime", nullptr},
          {"averagePrintTime", nullptr},
          {"lastPrintTime", nullptr},
          {"filament", nullptr},
          {"user", nullptr}};
}

Json octo_progress(const PrinterStatus& status) {
  if (status.job == 0) {
    return {{"completion", nullptr},
            {"filepos", nullptr},
            {"printTime", nullptr},
            {"printTimeLeft", nullptr},
            {"printTimeLeftOrigin", nullptr}};
  }
  const Json left = status.seconds_left ? Json(std::lround(*status.seconds_left)) : Json();
  return {{"completion", 100 * status.completion},
          {"filepos", nullptr},
          {"printTime", std::lround(status.seconds)},
          {"printTimeLeft", left},
          {"printTimeLeftOrigin", left.is_null() ? Json() : Json("linear")}};
}

Json octo_type_path(std::string_view name) {
  const auto checked = FileName::from(name);
  const bool is_gcode = checked && checked->is_gcode();
  return is_gcode ? Json::array({"machinecode", "gcode"}) : Json::array({"model", "stl"});
}

}  // namespace slipstick
