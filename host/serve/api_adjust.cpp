// What is changed in a print under way: /api/v1/printer/adjust and commands, and OctoPrint's.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "drivers/marlin/interjection.h"
#include "host/serve/api.h"
#include "host/serve/octoprint.h"

namespace slipstick {
namespace {

using Json = nlohmann::json;

using Dial = std::optional<double> Adjustment::*;
constexpr std::array<std::pair<std::string_view, Dial>, 6> kDials{{
    {"feed", &Adjustment::feed},
    {"flow", &Adjustment::flow},
    {"z", &Adjustment::z},
    {"nozzle", &Adjustment::nozzle},
    {"bed", &Adjustment::bed},
    {"fan", &Adjustment::fan},
}};

HttpResponse say(const Result<std::vector<Line>>& lines, Services& services) {
  if (!lines) return error_response(lines.error());
  const auto said = services.printer.interject(*lines);
  return said ? empty_response() : error_response(said.error());
}

Result<std::vector<Line>> lines_of_json(const Json& json) {
  if (!json.is_object()) return fail(ErrorCode::kInput, "the body must be a JSON object");
  Adjustment adjustment;
  for (const auto& [key, value] : json.items()) {
    const auto dial =
        std::ranges::find(kDials, key, [](const auto& d) { return std::string(d.first); });
    if (dial == kDials.end()) return fail(ErrorCode::kInput, key + ": there is no such member");
    if (!value.is_number()) return fail(ErrorCode::kInput, key + ": must be a number");
    adjustment.*dial->second = value.get<double>();
  }
  return lines_of(adjustment);
}

// Each of `json`, an array of texts, or the one text that it is.
Result<std::vector<Line>> commands_of(const Json& json) {
  const Json list = json.is_string() ? Json::array({json}) : json;
  if (!list.is_array() || list.size() > PrintControl::kInterjectionsMax)
    return fail(ErrorCode::kInput, fmt::format("commands: must be an array of at most {} texts",
                                               PrintControl::kInterjectionsMax));
  std::vector<Line> lines;
  for (const Json& text : list) {
    if (!text.is_string()) return fail(ErrorCode::kInput, "commands: must be texts");
    auto line = interjection(text.get_ref<const std::string&>());
    if (!line) return fail(line.error());
    lines.push_back(*std::move(line));
  }
  return lines;
}

Json member(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) ? json[key] : Json();
}

// OctoPrint takes 105 and 1.05 for the same.
Json percent(const Json& factor) {
  if (factor.is_number_float() && factor.get<double>() < 10) return factor.get<double>() * 100;
  return factor;
}

HttpResponse adjust(const char* what, const Json& value, Services& services) {
  return say(lines_of_json({{what, value}}), services);
}

HttpResponse cannot(std::string_view what) {
  return error_response(409, fmt::format("{} would disturb the print", what));
}

}  // namespace

HttpResponse adjust_printer(const HttpRequest& request, Services& services) {
  return say(lines_of_json(Json::parse(request.body, nullptr, false)), services);
}

HttpResponse command_printer(const HttpRequest& request, Services& services) {
  const Json json = Json::parse(request.body, nullptr, false);
  return say(commands_of(member(json, "commands")), services);
}

HttpResponse octo_printhead(const HttpRequest& request, Services& services) {
  const Json json = Json::parse(request.body, nullptr, false);
  const Json command = member(json, "command");
  if (command == "feedrate") return adjust("feed", percent(member(json, "factor")), services);
  if (command == "jog" || command == "home") return cannot("moving the head");
  return error_response(400, "command: jog, home or feedrate");
}

HttpResponse octo_tool(const HttpRequest& request, Services& services) {
  const Json json = Json::parse(request.body, nullptr, false);
  const Json command = member(json, "command");
  if (command == "flowrate") return adjust("flow", percent(member(json, "factor")), services);
  if (command == "target") {
    const Json targets = member(json, "targets");
    if (targets.size() != 1) return error_response(400, "targets: there is one tool, tool0");
    return adjust("nozzle", member(targets, "tool0"), services);
  }
  if (command == "extrude") return cannot("extruding");
  return error_response(400, "command: target, flowrate or extrude");
}

HttpResponse octo_bed(const HttpRequest& request, Services& services) {
  const Json json = Json::parse(request.body, nullptr, false);
  if (member(json, "command") == "target") return adjust("bed", member(json, "target"), services);
  return error_response(400, "command: target");
}

HttpResponse octo_gcode(const HttpRequest& request, Services& services) {
  const Json json = Json::parse(request.body, nullptr, false);
  const Json one = member(json, "command");
  return say(commands_of(one.is_null() ? member(json, "commands") : one), services);
}

}  // namespace slipstick
