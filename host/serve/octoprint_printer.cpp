// OctoPrint's API: what the printer does, and the job under way.
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/octoprint.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

Json heater(const HeaterReading& reading) {
  return {{"actual", std::isfinite(reading.celsius) ? Json(reading.celsius) : Json()},
          {"target", reading.target.value_or(0)},
          {"offset", 0}};
}

Json temperatures(const std::optional<Temperatures>& seen) {
  Json json = Json::object();
  if (seen && seen->hotend) json["tool0"] = heater(*seen->hotend);
  if (seen && seen->bed) json["bed"] = heater(*seen->bed);
  return json;
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

Json progress(const PrinterStatus& status) {
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

Json file_of(const std::string& name, Store& store) {
  const auto file = store.file(name);
  const bool known = file && *file;
  return {{"name", name.empty() ? Json() : Json(name)},
          {"display", name.empty() ? Json() : Json(name)},
          {"path", name.empty() ? Json() : Json(name)},
          {"origin", name.empty() ? Json() : Json("local")},
          {"size", known ? Json((**file).size) : Json()},
          {"date", known ? Json((**file).created) : Json()}};
}

HttpResponse start_selected(Services& services) {
  if (services.board.get().job != 0) return error_response(409, "a print is under way");
  const auto name = services.store.selected();
  if (!name) return error_response(name.error());
  const auto file = services.store.file(*name);
  if (!file) return error_response(file.error());
  if (!*file) return error_response(409, "no file is selected");
  const auto job = queue_job(**file, "{}", QueuePlace::kNow, services);
  return job ? empty_response() : error_response(job.error());
}

HttpResponse pause(const std::string& action, Services& services) {
  const bool paused = services.board.get().activity == PrinterActivity::kPaused;
  const bool resumes = action == "resume" || (action == "toggle" && paused);
  const bool applied = resumes ? services.printer.resume() : services.printer.pause();
  // To pause what is paused is no mistake.
  return applied || services.board.get().job != 0 ? empty_response()
                                                  : error_response(409, "no print is under way");
}

std::string text_of(const Json& json, const char* key, const char* otherwise) {
  return json.is_object() && json.contains(key) && json[key].is_string()
             ? json[key].get<std::string>()
             : otherwise;
}

}  // namespace

std::string_view octo_state(PrinterActivity activity) {
  constexpr std::array<std::string_view, 5> kTexts{"Operational", "Printing", "Paused",
                                                   "Cancelling", "Error"};
  return kTexts[static_cast<std::size_t>(activity)];
}

HttpResponse octo_printer(const HttpRequest&, Services& services) {
  const PrinterStatus status = services.board.get();
  if (status.activity == PrinterActivity::kStopped) {
    return error_response(409, "Printer is not operational");
  }
  return json_response(
      {{"temperature", temperatures(status.temperatures)},
       {"sd", {{"ready", false}}},
       {"state", {{"text", octo_state(status.activity)}, {"flags", flags(status.activity)}}}});
}

HttpResponse octo_job(const HttpRequest&, Services& services) {
  const PrinterStatus status = services.board.get();
  std::string name = status.file;
  if (status.job == 0) {
    const auto selected = services.store.selected();
    if (!selected) return error_response(selected.error());
    name = *selected;
  }
  return json_response({{"job",
                         {{"file", file_of(name, services.store)},
                          {"estimatedPrintTime", nullptr},
                          {"averagePrintTime", nullptr},
                          {"lastPrintTime", nullptr},
                          {"filament", nullptr},
                          {"user", nullptr}}},
                        {"progress", progress(status)},
                        {"state", octo_state(status.activity)}});
}

HttpResponse octo_command(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  const std::string command = text_of(json, "command", "");
  if (command == "start") return start_selected(services);
  if (command == "pause") return pause(text_of(json, "action", "toggle"), services);
  if (command == "cancel") {
    return services.printer.cancel(services.board.get().job)
               ? empty_response()
               : error_response(409, "no print is under way");
  }
  if (command == "restart") return error_response(409, "cancel the print and start it again");
  return error_response(400, "command: start, pause or cancel");
}

}  // namespace slipstick
