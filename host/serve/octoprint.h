#pragma once

#include "host/serve/routes.h"

namespace slipstick {

/// \file
/// The part of OctoPrint's API that slicers and phone apps use (OctoPrint 1.10, docs/api), so that
/// they work with this daemon unchanged.

// octoprint_system.cpp
[[nodiscard]] HttpResponse octo_version(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_server(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_login(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_user(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_settings(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_profiles(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_connection(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_connect(const HttpRequest& request, Services& services);

// octoprint_printer.cpp
[[nodiscard]] HttpResponse octo_printer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_job(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse octo_command(const HttpRequest& request, Services& services);

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

/// "Operational", "Printing", "Paused", "Cancelling" or "Error".
[[nodiscard]] std::string_view octo_state(PrinterActivity activity);

}  // namespace slipstick
