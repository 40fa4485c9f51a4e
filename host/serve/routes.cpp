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

constexpr std::array kRoutes{
    Route{kGet, "/", get_page, RouteBody::kText, RouteKind::kQuick, RouteAccess::kAnyone},
    Route{kGet, "/assets/{name}", get_asset, RouteBody::kText, RouteKind::kQuick,
          RouteAccess::kAnyone},

    Route{kGet, "/metrics", get_metrics},

    Route{kGet, "/api/v1/files", get_files},
    Route{kGet, "/api/v1/files/{name}", get_file},
    Route{kPut, "/api/v1/files/{name}", put_file, RouteBody::kUpload},
    Route{kDelete, "/api/v1/files/{name}", delete_file},
    Route{kGet, "/api/v1/files/{name}/picture", get_picture, RouteBody::kText, RouteKind::kSlow},
    Route{kGet, "/api/v1/files/{name}/layers", get_layers, RouteBody::kText, RouteKind::kSlow},
    Route{kGet, "/api/v1/files/{name}/layers/{layer}", get_layer, RouteBody::kText,
          RouteKind::kSlow},
    Route{kGet, "/api/v1/jobs", get_jobs},
    Route{kPost, "/api/v1/jobs", post_job},
    Route{kGet, "/api/v1/jobs/{id}", get_job},
    Route{kPost, "/api/v1/jobs/{id}/cancel", cancel_job},
    Route{kPost, "/api/v1/jobs/{id}/take-up", take_up_job},
    Route{kPost, "/api/v1/jobs/{id}/settings", change_settings},
    Route{kGet, "/api/v1/printer", get_printer},
    Route{kGet, "/api/v1/printer/layer", get_printed_layer},
    Route{kPost, "/api/v1/printer/pause", pause_printer},
    Route{kPost, "/api/v1/printer/resume", resume_printer},
    Route{kPost, "/api/v1/printer/adjust", adjust_printer},
    Route{kPost, "/api/v1/printer/commands", command_printer},
    Route{kPost, "/api/v1/printer/emergency-stop", stop_printer},
    Route{kPost, "/api/v1/printer/bed-cleared", clear_bed},
    Route{kGet, "/api/v1/camera", get_camera},
    Route{kGet, "/api/v1/settings", get_settings},
    Route{kGet, "/api/v1/events", get_events, RouteBody::kText, RouteKind::kEvents},

    // OctoPrint's.
    Route{kGet, "/api/version", octo_version},
    Route{kGet, "/api/server", octo_server},
    Route{kPost, "/api/login", octo_login},
    Route{kGet, "/api/currentuser", octo_user},
    Route{kGet, "/api/settings", octo_settings},
    Route{kGet, "/api/printerprofiles", octo_profiles},
    Route{kGet, "/api/connection", octo_connection},
    Route{kPost, "/api/connection", octo_connect},
    Route{kGet, "/api/printer", octo_printer},
    Route{kPost, "/api/printer/printhead", octo_printhead},
    Route{kPost, "/api/printer/tool", octo_tool},
    Route{kPost, "/api/printer/bed", octo_bed},
    Route{kPost, "/api/printer/command", octo_gcode},
    Route{kGet, "/api/job", octo_job},
    Route{kPost, "/api/job", octo_command},
    Route{kGet, "/api/files", octo_files},
    Route{kGet, "/api/files/local", octo_files},
    Route{kPost, "/api/files/local", octo_upload, RouteBody::kForm},
    Route{kGet, "/api/files/local/{name}", octo_file},
    Route{kPost, "/api/files/local/{name}", octo_select},
    Route{kDelete, "/api/files/local/{name}", delete_file},
    Route{kGet, "/sockjs/info", octo_push_info, RouteBody::kText, RouteKind::kQuick,
          RouteAccess::kAnyone},
    Route{kGet, "/sockjs/websocket", octo_no_push, RouteBody::kText, RouteKind::kPush,
          RouteAccess::kAnyone},
    Route{kGet, "/sockjs/{server}/{session}/websocket", octo_no_push, RouteBody::kText,
          RouteKind::kPush, RouteAccess::kAnyone},

    // PrusaLink's. No file of ours is called "local", so that the addresses are no others'.
    Route{kGet, "/api/v1/storage", link_storage},
    Route{kPut, "/api/v1/files/local/{path}", link_put_file, RouteBody::kUpload},

    // Moonraker's.
    Route{kGet, "/server/info", moon_info},
    Route{kGet, "/server/files/roots", moon_roots},
    Route{kPost, "/server/files/upload", moon_upload, RouteBody::kForm},

    // Repetier-Server's.
    Route{kGet, "/printer/info", repetier_info},
    Route{kGet, "/printer/list", repetier_list},
    Route{kPost, "/printer/api/{slug}", repetier_ask, RouteBody::kForm},
    Route{kPost, "/printer/model/{slug}", repetier_upload, RouteBody::kForm},
    Route{kPost, "/printer/job/{slug}", repetier_print, RouteBody::kForm},
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
