// OctoPrint's API: what the printer does, and the job under way.
#include <ctime>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/octoprint.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

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

Result<OctoMoment> octo_moment(Services& services) {
  OctoMoment moment{services.board.get(), "", {}, std::int64_t{std::time(nullptr)}};
  moment.name = moment.status.file;
  if (moment.status.job == 0) {
    auto selected = services.store.selected();
    if (!selected) return fail(selected.error());
    moment.name = std::move(*selected);
  }
  auto file = services.store.file(moment.name);
  if (!file) return fail(file.error());
  moment.file = std::move(*file);
  return moment;
}

HttpResponse octo_printer(const HttpRequest&, Services& services) {
  const PrinterStatus status = services.board.get();
  if (status.activity == PrinterActivity::kStopped) {
    return error_response(409, "Printer is not operational");
  }
  return json_response({{"temperature", octo_temperatures(status.temperatures)},
                        {"sd", {{"ready", false}}},
                        {"state", octo_state_of(status.activity)}});
}

HttpResponse octo_job(const HttpRequest&, Services& services) {
  const auto moment = octo_moment(services);
  if (!moment) return error_response(moment.error());
  return json_response({{"job", octo_job_of(*moment)},
                        {"progress", octo_progress(moment->status)},
                        {"state", octo_state(moment->status.activity)}});
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
