// What is said to the printer, in a print and between prints: /api/v1/printer/adjust and commands,
// and OctoPrint's.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/marlin/interjection.h"
#include "host/serve/api.h"
#include "host/serve/octoprint.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

using Commands = std::vector<std::string>;

HttpResponse say(const Result<Commands>& commands, Services& services) {
  if (!commands) return error_response(commands.error());
  const auto said = services.printer.say(*commands);
  return said ? empty_response() : error_response(said.error());
}

Result<Commands> adjustment(const Json& json) {
  if (!json.is_object()) return fail(ErrorCode::kInput, "the body must be a JSON object");
  Adjustment adjustment;
  for (const auto& [key, value] : json.items()) {
    std::optional<double>* const dial = member_of(adjustment, key);
    if (dial == nullptr) return fail(ErrorCode::kInput, key + ": there is no such member");
    if (!value.is_number()) return fail(ErrorCode::kInput, key + ": must be a number");
    *dial = value.get<double>();
  }
  const auto lines = lines_of(adjustment);
  if (!lines) return fail(lines.error());
  Commands commands;
  for (const Line& line : *lines) commands.push_back(line.text());
  return commands;
}

// Each of `json`, an array of texts, or the one text that it is.
Result<Commands> commands_of(const Json& json) {
  const Json list = json.is_string() ? Json::array({json}) : json;
  if (!list.is_array() || list.size() > PrintControl::kInterjectionsMax)
    return fail(ErrorCode::kInput, fmt::format("commands: must be an array of at most {} texts",
                                               PrintControl::kInterjectionsMax));
  Commands commands;
  for (const Json& text : list) {
    if (!text.is_string()) return fail(ErrorCode::kInput, "commands: must be texts");
    commands.push_back(text.get<std::string>());
  }
  return commands;
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
  return say(adjustment(Json{{what, value}}), services);
}

HttpResponse move(const Result<Commands>& commands, Services& services) {
  if (services.board.get().job != 0) return error_response(409, "it would disturb the print");
  return say(commands, services);
}

// Of {"x": 10}, as a relative move; at most so far as a bed is wide.
Result<Commands> jog(const Json& json) {
  constexpr double kFarthest = 500;  // mm
  std::string words;
  for (const char* axis : {"x", "y", "z"}) {
    const Json way = member(json, axis);
    if (way.is_null()) continue;
    if (!way.is_number() || std::abs(way.get<double>()) > kFarthest)
      return fail(ErrorCode::kInput, fmt::format("{}: must be a number up to {}", axis, kFarthest));
    words += fmt::format(" {}{:.3f}", static_cast<char>(std::toupper(*axis)), way.get<double>());
  }
  if (words.empty()) return fail(ErrorCode::kInput, "x, y or z: how far to move, mm");
  const double speed = json.value("speed", Json()).is_number() ? json["speed"].get<double>() : 1500;
  return Commands{"G91", fmt::format("G0{} F{:.0f}", words, std::clamp(speed, 1.0, 30'000.0)),
                  "G90"};
}

Result<Commands> home(const Json& json) {
  const Json axes = member(json, "axes");
  std::string line = "G28";
  for (const Json& axis : axes.is_array() ? axes : Json::array()) {
    if (axis != "x" && axis != "y" && axis != "z")
      return fail(ErrorCode::kInput, "axes: must be of x, y and z");
    line += fmt::format(" {}", static_cast<char>(std::toupper(axis.get<std::string>()[0])));
  }
  return Commands{line};
}

Result<Commands> extrude(const Json& json) {
  constexpr double kMost = 100;  // mm of filament
  const Json amount = member(json, "amount");
  if (!amount.is_number() || std::abs(amount.get<double>()) > kMost)
    return fail(ErrorCode::kInput, fmt::format("amount: must be a number up to {}", kMost));
  return Commands{"M83", fmt::format("G1 E{:.3f} F300", amount.get<double>()), "M82"};
}

}  // namespace

HttpResponse adjust_printer(const HttpRequest& request, Services& services) {
  return say(adjustment(parse_json(request.body)), services);
}

HttpResponse command_printer(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  return say(commands_of(member(json, "commands")), services);
}

HttpResponse octo_printhead(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  const Json command = member(json, "command");
  if (command == "feedrate") return adjust("feed", percent(member(json, "factor")), services);
  if (command == "jog") return move(jog(json), services);
  if (command == "home") return move(home(json), services);
  return error_response(400, "command: jog, home or feedrate");
}

HttpResponse octo_tool(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  const Json command = member(json, "command");
  if (command == "flowrate") return adjust("flow", percent(member(json, "factor")), services);
  if (command == "target") {
    const Json targets = member(json, "targets");
    if (targets.size() != 1) return error_response(400, "targets: there is one tool, tool0");
    return adjust("nozzle", member(targets, "tool0"), services);
  }
  if (command == "extrude") return move(extrude(json), services);
  return error_response(400, "command: target, flowrate or extrude");
}

HttpResponse octo_bed(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  if (member(json, "command") == "target") return adjust("bed", member(json, "target"), services);
  return error_response(400, "command: target");
}

HttpResponse octo_gcode(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  const Json one = member(json, "command");
  return say(commands_of(one.is_null() ? member(json, "commands") : one), services);
}

}  // namespace slipstick
