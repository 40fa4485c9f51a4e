#pragma once

#include <nlohmann/json_fwd.hpp>

#include "host/serve/routes.h"

namespace slipstick {

/// \file
/// The handlers of /api/v1, the page and /metrics; docs/openapi.json describes each.

// api_web.cpp
[[nodiscard]] HttpResponse get_page(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_login_page(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_setup_page(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_asset(const HttpRequest& request, Services& services);

/// Where the camera is, for the page.
[[nodiscard]] HttpResponse get_camera(const HttpRequest& request, Services& services);
// api_session.cpp
[[nodiscard]] HttpResponse get_session(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_setup(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_login(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_logout(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_logout_everywhere(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_password(const HttpRequest& request, Services& services);

// api_keys.cpp
[[nodiscard]] HttpResponse get_keys(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_key(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse delete_key(const HttpRequest& request, Services& services);

// api_apps.cpp
[[nodiscard]] HttpResponse get_app_requests(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_app_request(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse delete_app_request(const HttpRequest& request, Services& services);

// api_machine.cpp
[[nodiscard]] HttpResponse get_machine(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse put_machine(const HttpRequest& request, Services& services);

// api_files.cpp
[[nodiscard]] HttpResponse get_files(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_file(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse put_file(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse delete_file(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_picture(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_layers(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_layer(const HttpRequest& request, Services& services);
[[nodiscard]] nlohmann::ordered_json to_json(const StoredFile& file);

// api_jobs.cpp
[[nodiscard]] HttpResponse get_jobs(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse post_job(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_job(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse cancel_job(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse take_up_job(const HttpRequest& request, Services& services);
/// `{id}` of the address, if it is a number.
[[nodiscard]] std::optional<std::int64_t> id_in(const HttpRequest& request);

// api_pauses.cpp
[[nodiscard]] HttpResponse put_pauses(const HttpRequest& request, Services& services);

// api_changes.cpp
[[nodiscard]] HttpResponse change_settings(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse cancel_object(const HttpRequest& request, Services& services);

enum class QueuePlace : std::uint8_t {
  kLast,
  kNow,  ///< First, and if nothing is being printed whoever asks says that the bed is clear.
};
/// Adds a job whose spec is known to be good.
[[nodiscard]] Result<StoredJob> queue_job(const StoredFile& file, std::string_view spec,
                                          QueuePlace place, Services& services);

// api_metrics.cpp
[[nodiscard]] HttpResponse get_metrics(const HttpRequest& request, Services& services);

// api_printer.cpp
[[nodiscard]] HttpResponse get_printer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_printed_layer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse pause_printer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse resume_printer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse stop_printer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse clear_bed(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_settings(const HttpRequest& request, Services& services);
/// What a stream of events begins with.
[[nodiscard]] HttpResponse get_events(const HttpRequest& request, Services& services);

// api_serial_log.cpp
[[nodiscard]] HttpResponse get_serial_log(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse put_serial_log(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse get_serial_lines(const HttpRequest& request, Services& services);

// api_adjust.cpp
[[nodiscard]] HttpResponse adjust_printer(const HttpRequest& request, Services& services);
[[nodiscard]] HttpResponse command_printer(const HttpRequest& request, Services& services);

}  // namespace slipstick
