#pragma once

#include "host/serve/octoprint_state.h"
#include "host/serve/routes.h"

namespace slipstick {

/// \file
/// The part of OctoPrint's API that slicers and phone apps use (OctoPrint 1.10, docs/api), so that
/// they work with this daemon unchanged.

/// Whom a login answers for.
inline constexpr const char* kOctoPrintUser = "slipstick";

// octoprint_system.cpp
[[nodiscard]] HttpResponse octo_version(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_server(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_login(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_user(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_settings(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_profiles(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_connection(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_connect(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_push_info(const HttpRequest& request, Services& services);
/// 426: what is no WebSocket.
[[nodiscard]] HttpResponse octo_no_push(const HttpRequest& request, Services& services);

// api_apps.cpp
[[nodiscard]] HttpResponse octo_appkeys_probe(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_appkeys_request(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_appkeys_answer(const HttpRequest& request, Services& services);

// octoprint_printer.cpp
[[nodiscard]] HttpResponse octo_printer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_job(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_command(const HttpRequest& request, Services& services);
/// \return kUnavailable, as of any look into the store.
[[nodiscard]] Result<OctoMoment> octo_moment(Services& services);

// api_adjust.cpp
[[nodiscard]] HttpResponse octo_printhead(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_tool(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_bed(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_gcode(const HttpRequest& request, Services& services);

// octoprint_files.cpp
[[nodiscard]] HttpResponse octo_files(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_file(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_upload(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_select(const HttpRequest& request, Services& services);

}  // namespace slipstick
