// OctoPrint's API: who and what this is.
#include <nlohmann/json.hpp>
#include <random>

#include "host/serve/octoprint.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const Caller& caller) {
  return caller.name.empty() ? kOctoPrintUser : caller.name;
}

Json groups_of(const Caller& caller) {
  return caller.scope == Scope::kAdmin ? Json{"admins", "users"} : Json::array({"users"});
}

}  // namespace

// Slicers want the text to begin with "OctoPrint"; the capability is for those that look for a
// PrusaLink.
HttpResponse octo_version(const HttpRequest&, Services&) {
  return json_response({{"api", "0.1"},
                        {"server", kOctoPrintRelease},
                        {"text", std::string("OctoPrint ") + kOctoPrintRelease +
                                     " (slipstick " SLIPSTICK_VERSION ")"},
                        {"capabilities", {{"upload-by-put", true}}}});
}

HttpResponse octo_server(const HttpRequest&, Services&) {
  return json_response({{"version", kOctoPrintRelease}, {"safemode", nullptr}});
}

HttpResponse octo_login(const HttpRequest& request, Services& services) {
  return json_response({{"name", name_of(request.caller)},
                        {"active", true},
                        {"admin", request.caller.scope == Scope::kAdmin},
                        {"user", true},
                        {"apikey", nullptr},
                        {"session", services.push_session},
                        {"groups", groups_of(request.caller)},
                        {"permissions", Json::array()},
                        {"needs", Json::object()}});
}

HttpResponse octo_user(const HttpRequest& request, Services&) {
  return json_response({{"name", name_of(request.caller)},
                        {"groups", groups_of(request.caller)},
                        {"permissions", Json::array()}});
}

HttpResponse octo_settings(const HttpRequest&, Services&) {
  return json_response({{"feature", {{"sdSupport", false}, {"modelSizeDetection", false}}},
                        {"webcam", {{"webcamEnabled", false}, {"streamUrl", ""}}},
                        {"temperature", {{"profiles", Json::array()}}},
                        {"plugins", Json::object()}});
}

HttpResponse octo_profiles(const HttpRequest&, Services& services) {
  const auto settings = load_settings(default_settings(services.printer.defaults()));
  if (!settings) return error_response(settings.error());
  const PrinterSettings& printer = settings->printer;
  const bool round = printer.bed_shape == BedShape::kRound;
  Json profile{{"id", "_default"},
               {"name", printer.name},
               {"current", true},
               {"default", true},
               {"heatedBed", true},
               {"volume",
                {{"formFactor", round ? "circular" : "rectangular"},
                 {"origin", round ? "center" : "lowerleft"},
                 {"width", printer.bed_size.x},
                 {"depth", printer.bed_size.y},
                 {"height", printer.bed_size.z}}},
               {"extruder", {{"count", 1}, {"nozzleDiameter", printer.nozzle_diameter}}}};
  return json_response({{"profiles", {{"_default", std::move(profile)}}}});
}

HttpResponse octo_connection(const HttpRequest&, Services& services) {
  const std::string port = services.printer.port();
  const Json ports = Json::array({port});
  const Json profiles = Json::array({{{"id", "_default"}, {"name", "Default"}}});
  return json_response({{"current",
                         {{"state", octo_state(services.board.get().activity)},
                          {"port", port},
                          {"baudrate", nullptr},
                          {"printerProfile", "_default"}}},
                        {"options",
                         {{"ports", ports},
                          {"baudrates", Json::array()},
                          {"printerProfiles", profiles},
                          {"portPreference", port},
                          {"baudratePreference", nullptr},
                          {"printerProfilePreference", "_default"},
                          {"autoconnect", true}}}});
}

// The printer is connected when there is something to print; nothing is to be done.
HttpResponse octo_connect(const HttpRequest& request, Services& services) {
  const Json json = parse_json(request.body);
  const std::string command =
      json.is_object() && json.contains("command") ? json["command"].dump() : "";
  if (command == "\"connect\"" || command == "\"fake_ack\"") return empty_response();
  if (command != "\"disconnect\"") return error_response(400, "command: connect or disconnect");
  if (services.board.get().job == 0) return empty_response();
  return error_response(409, "a print is under way");
}

// Nothing but WebSockets is offered to SockJS.
HttpResponse octo_push_info(const HttpRequest&, Services&) {
  return json_response({{"websocket", true},
                        {"origins", {"*:*"}},
                        {"cookie_needed", false},
                        {"entropy", std::random_device{}()}});
}

HttpResponse octo_no_push(const HttpRequest&, Services&) {
  HttpResponse response = error_response(426, "this address takes WebSockets");
  response.headers.emplace_back("Upgrade", "websocket");
  return response;
}

}  // namespace slipstick
