// Moonraker's API: what slicers ask of it before they upload.
#include <nlohmann/json.hpp>

#include "host/serve/received_file.h"
#include "host/serve/slicer_hosts.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRoot = "gcodes";  // where files are, in Moonraker's words

HttpResponse result(const Json& json, unsigned status = 200) {
  return json_response({{"result", json}}, status);
}

}  // namespace

HttpResponse moon_info(const HttpRequest&, Services& services) {
  const bool stopped = services.board.get().activity == PrinterActivity::kStopped;
  return result({{"klippy_connected", true},
                 {"klippy_state", stopped ? "shutdown" : "ready"},
                 {"components", Json::array()},
                 {"failed_components", Json::array()},
                 {"registered_directories", {kRoot}},
                 {"warnings", Json::array()},
                 {"moonraker_version", "slipstick " SLIPSTICK_VERSION},
                 {"api_version", {1, 4, 0}},
                 {"api_version_string", "1.4.0"}});
}

HttpResponse moon_roots(const HttpRequest&, Services&) {
  return result(Json::array({Json{{"name", kRoot}, {"path", kRoot}, {"permissions", "rw"}}}));
}

HttpResponse moon_upload(const HttpRequest& request, Services& services) {
  const std::string root = form_field(request, "root");
  if (!root.empty() && root != kRoot) return error_response(400, "root: there is gcodes");
  const ReceivedFile received = receive_form(request, services);
  if (received.refusal) return *received.refusal;
  const bool print = form_field(request, "print") == "true";
  const bool busy = services.board.get().job != 0;
  if (print) {
    if (const auto ok = print_file(received.file, services); !ok) return error_response(ok.error());
  }
  return result({{"item",
                  {{"path", received.file.name},
                   {"root", kRoot},
                   {"size", received.file.size},
                   {"modified", received.file.created},
                   {"permissions", "rw"}}},
                 {"print_started", print && !busy},
                 {"print_queued", print && busy},
                 {"action", "create_file"}},
                201);
}

}  // namespace slipstick
