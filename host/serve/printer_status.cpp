#include "host/serve/printer_status.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> kNames{"idle", "printing", "paused", "ending", "stopped"};

// JSON has no NaN; a broken sensor has no temperature.
Json celsius(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json to_json(const HeaterReading& heater) {
  return {{"actual", celsius(heater.celsius)},
          {"target", heater.target ? celsius(*heater.target) : Json()}};
}

}  // namespace

std::string_view name_of(PrinterActivity activity) {
  return kNames[static_cast<std::size_t>(activity)];
}

Json to_json(const Temperatures& temperatures) {
  Json json = Json::object();
  if (temperatures.hotend) json["nozzle"] = to_json(*temperatures.hotend);
  if (temperatures.bed) json["bed"] = to_json(*temperatures.bed);
  if (temperatures.chamber) json["chamber"] = to_json(*temperatures.chamber);
  return json;
}

Json to_json(const PrinterStatus& status) {
  Json json{{"state", name_of(status.activity)},
            {"message", status.message},
            {"firmware", status.firmware},
            {"connected", status.connected},
            {"bed_occupied", status.bed_occupied},
            {"temperatures", status.temperatures ? to_json(*status.temperatures) : Json::object()},
            {"job", Json()}};
  if (status.job == 0) return json;
  json["job"] = {{"id", status.job},
                 {"file", status.file},
                 {"lines", status.lines},
                 {"resends", status.resends},
                 {"starved_seconds", status.starved_seconds},
                 {"turnaround_p50", status.turnaround_half},
                 {"turnaround_p99", status.turnaround_99},
                 {"layer", status.layer},
                 {"layers", status.layers},
                 {"height", status.height},
                 {"completion", status.completion},
                 {"seconds", status.seconds},
                 {"seconds_left", status.seconds_left ? Json(*status.seconds_left) : Json()}};
  return json;
}

}  // namespace slipstick
