#include "host/serve/routes.h"

#include <array>

#include "host/serve/api.h"
#include "host/serve/octoprint.h"
#include "host/serve/slicer_hosts.h"

namespace slipstick {
namespace {

constexpr auto kGet = HttpMethod::kGet;
constexpr auto kPost = HttpMethod::kPost;
constexpr auto kPut = HttpMethod::kPut;
constexpr auto kDelete = HttpMethod::kDelete;
constexpr auto kAnyone = RouteAccess::kAnyone;
constexpr auto kRead = RouteAccess::kRead;
constexpr auto kPrint = RouteAccess::kPrint;
constexpr auto kControl = RouteAccess::kControl;
constexpr auto kAdmin = RouteAccess::kAdmin;
constexpr auto kAccount = RouteAccess::kAccount;

constexpr std::array kRoutes{
    Route{kGet, "/", kAnyone, get_page},
    Route{kGet, "/assets/{name}", kAnyone, get_asset},

    Route{kGet, "/login", kAnyone, get_login_page},
    Route{kGet, "/setup", kAnyone, get_setup_page},
    Route{kGet, "/api/v1/session", kAnyone, get_session},
    Route{kPost, "/api/v1/setup", kAnyone, post_setup, RouteBody::kText, RouteKind::kSecret},
    Route{kPost, "/api/v1/login", kAnyone, post_login, RouteBody::kText, RouteKind::kSecret},
    Route{kPost, "/api/v1/logout", kAccount, post_logout},
    Route{kPost, "/api/v1/logout-everywhere", kAccount, post_logout_everywhere},
    Route{kPost, "/api/v1/password", kAccount, post_password, RouteBody::kText, RouteKind::kSecret},
    Route{kGet, "/api/v1/keys", kAdmin, get_keys},
    Route{kPost, "/api/v1/keys", kAccount, post_key, RouteBody::kText, RouteKind::kSecret},
    Route{kDelete, "/api/v1/keys/{id}", kAdmin, delete_key},
    Route{kGet, "/api/v1/app-requests", kAdmin, get_app_requests, RouteBody::kText,
          RouteKind::kSlow},
    Route{kPost, "/api/v1/app-requests/{id}", kAccount, post_app_request, RouteBody::kText,
          RouteKind::kSecret},
    Route{kDelete, "/api/v1/app-requests/{id}", kAdmin, delete_app_request, RouteBody::kText,
          RouteKind::kSlow},
    Route{kGet, "/api/v1/machine", kAdmin, get_machine, RouteBody::kText, RouteKind::kSlow},
    Route{kPut, "/api/v1/machine", kAdmin, put_machine, RouteBody::kText, RouteKind::kSlow},

    Route{kGet, "/metrics", kRead, get_metrics},

    Route{kGet, "/api/v1/files", kRead, get_files},
    Route{kGet, "/api/v1/files/{name}", kRead, get_file},
    Route{kPut, "/api/v1/files/{name}", kPrint, put_file, RouteBody::kUpload},
    Route{kDelete, "/api/v1/files/{name}", kPrint, delete_file},
    Route{kGet, "/api/v1/files/{name}/picture", kRead, get_picture, RouteBody::kText,
          RouteKind::kSlow},
    Route{kGet, "/api/v1/files/{name}/layers", kRead, get_layers, RouteBody::kText,
          RouteKind::kSlow},
    Route{kGet, "/api/v1/files/{name}/layers/{layer}", kRead, get_layer, RouteBody::kText,
          RouteKind::kSlow},
    Route{kGet, "/api/v1/jobs", kRead, get_jobs},
    Route{kPost, "/api/v1/jobs", kPrint, post_job},
    Route{kGet, "/api/v1/jobs/{id}", kRead, get_job},
    Route{kPost, "/api/v1/jobs/{id}/cancel", kPrint, cancel_job},
    Route{kPost, "/api/v1/jobs/{id}/take-up", kPrint, take_up_job},
    Route{kPost, "/api/v1/jobs/{id}/settings", kPrint, change_settings},
    Route{kPost, "/api/v1/jobs/{id}/cancel-object", kPrint, cancel_object},
    Route{kPut, "/api/v1/jobs/{id}/pauses", kPrint, put_pauses},
    Route{kGet, "/api/v1/printer", kRead, get_printer},
    Route{kGet, "/api/v1/printer/layer", kRead, get_printed_layer},
    Route{kPost, "/api/v1/printer/pause", kPrint, pause_printer},
    Route{kPost, "/api/v1/printer/resume", kPrint, resume_printer},
    Route{kPost, "/api/v1/printer/adjust", kControl, adjust_printer},
    Route{kPost, "/api/v1/printer/commands", kControl, command_printer},
    Route{kGet, "/api/v1/printer/serial-log", kAdmin, get_serial_log},
    Route{kPut, "/api/v1/printer/serial-log", kAdmin, put_serial_log},
    Route{kGet, "/api/v1/printer/serial-log/lines", kAdmin, get_serial_lines, RouteBody::kText,
          RouteKind::kSlow},
    Route{kPost, "/api/v1/printer/emergency-stop", kPrint, stop_printer},
    Route{kPost, "/api/v1/printer/bed-cleared", kPrint, clear_bed},
    Route{kGet, "/api/v1/camera", kRead, get_camera},
    Route{kGet, "/api/v1/settings", kRead, get_settings},
    Route{kGet, "/api/v1/events", kRead, get_events, RouteBody::kText, RouteKind::kEvents},

    // OctoPrint's.
    Route{kGet, "/api/version", kRead, octo_version},
    Route{kGet, "/api/server", kRead, octo_server},
    Route{kPost, "/api/login", kRead, octo_login},
    Route{kGet, "/api/currentuser", kRead, octo_user},
    Route{kGet, "/api/settings", kRead, octo_settings},
    Route{kGet, "/api/printerprofiles", kRead, octo_profiles},
    Route{kGet, "/api/connection", kRead, octo_connection},
    Route{kPost, "/api/connection", kPrint, octo_connect},
    Route{kGet, "/api/printer", kRead, octo_printer},
    Route{kPost, "/api/printer/printhead", kControl, octo_printhead},
    Route{kPost, "/api/printer/tool", kControl, octo_tool},
    Route{kPost, "/api/printer/bed", kControl, octo_bed},
    Route{kPost, "/api/printer/command", kControl, octo_gcode},
    Route{kGet, "/api/job", kRead, octo_job},
    Route{kPost, "/api/job", kPrint, octo_command},
    Route{kGet, "/api/files", kRead, octo_files},
    Route{kGet, "/api/files/local", kRead, octo_files},
    Route{kPost, "/api/files/local", kPrint, octo_upload, RouteBody::kForm},
    Route{kGet, "/api/files/local/{name}", kRead, octo_file},
    Route{kPost, "/api/files/local/{name}", kPrint, octo_select},
    Route{kDelete, "/api/files/local/{name}", kPrint, delete_file},
    Route{kGet, "/plugin/appkeys/probe", kAnyone, octo_appkeys_probe},
    Route{kPost, "/plugin/appkeys/request", kAnyone, octo_appkeys_request, RouteBody::kText,
          RouteKind::kSlow},
    Route{kGet, "/plugin/appkeys/request/{token}", kAnyone, octo_appkeys_answer, RouteBody::kText,
          RouteKind::kSlow},
    Route{kGet, "/sockjs/info", kAnyone, octo_push_info},
    Route{kGet, "/sockjs/websocket", kAnyone, octo_no_push, RouteBody::kText, RouteKind::kPush},
    Route{kGet, "/sockjs/{server}/{session}/websocket", kAnyone, octo_no_push, RouteBody::kText,
          RouteKind::kPush},

    // PrusaLink's. No file of ours is called "local", so that the addresses are no others'.
    Route{kGet, "/api/v1/storage", kRead, link_storage},
    Route{kPut, "/api/v1/files/local/{path}", kPrint, link_put_file, RouteBody::kUpload},

    // Moonraker's.
    Route{kGet, "/server/info", kRead, moon_info},
    Route{kGet, "/server/files/roots", kRead, moon_roots},
    Route{kPost, "/server/files/upload", kPrint, moon_upload, RouteBody::kForm},

    // Repetier-Server's.
    Route{kGet, "/printer/info", kRead, repetier_info},
    Route{kGet, "/printer/list", kRead, repetier_list},
    Route{kPost, "/printer/api/{slug}", kRead, repetier_ask, RouteBody::kForm},
    Route{kPost, "/printer/model/{slug}", kPrint, repetier_upload, RouteBody::kForm},
    Route{kPost, "/printer/job/{slug}", kPrint, repetier_print, RouteBody::kForm},
};

bool is_parameter(std::string_view segment) {
  return segment.starts_with('{');
}

// All segments from `first` on, as one path.
std::string rest_of(const HttpTarget& target, std::size_t first) {
  std::string path = target.path[first];
  for (std::size_t i = first + 1; i < target.path.size(); ++i) path += "/" + target.path[i];
  return path;
}

// Whether `target` has the form of `pattern`; then its parameters are in `parameters`.
bool matches(std::string_view pattern, const HttpTarget& target,
             std::map<std::string, std::string>& parameters) {
  parameters.clear();
  pattern.remove_prefix(1);
  for (std::size_t i = 0; i < target.path.size(); ++i) {
    const std::size_t end = std::min(pattern.find('/'), pattern.size());
    const std::string_view segment = pattern.substr(0, end);
    if (segment == "{path}") {
      parameters.emplace("path", rest_of(target, i));
      return !target.path.back().empty();
    }
    if (is_parameter(segment)) {
      if (target.path[i].empty()) return false;
      parameters.emplace(segment.substr(1, segment.size() - 2), target.path[i]);
    } else if (segment != target.path[i]) {
      return false;
    }
    const bool last = i + 1 == target.path.size();
    if (end == pattern.size()) return last;
    if (last) return false;
    pattern.remove_prefix(end + 1);
  }
  return false;
}

std::string_view name_of(HttpMethod method) {
  constexpr std::array<std::string_view, 5> kNames{"GET", "POST", "PUT", "DELETE", "other"};
  return kNames[static_cast<std::size_t>(method)];
}

}  // namespace

std::span<const Route> routes() {
  return kRoutes;
}

Found find_route(HttpMethod method, const HttpTarget& target) {
  std::string others;
  std::map<std::string, std::string> parameters;
  for (const Route& route : kRoutes) {
    if (!matches(route.pattern, target, parameters)) continue;
    if (route.method == method) return {&route, std::move(parameters)};
    others += (others.empty() ? "" : ", ") + std::string(name_of(route.method));
  }
  if (others.empty()) return {nullptr, {}, error_response(404, "there is nothing here")};
  HttpResponse refusal = error_response(405, "this address takes " + others);
  refusal.headers.emplace_back("Allow", others);
  return {nullptr, {}, std::move(refusal)};
}

}  // namespace slipstick
