// The messages of OctoPrint's push socket: the state.
#include "host/serve/octoprint_push.h"

#include <nlohmann/json.hpp>

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

std::string one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json temperature_points(const OctoMoment& moment) {
  if (!moment.status.temperatures) return Json::array();
  Json point{{"time", moment.time}};
  point.update(octo_temperatures(moment.status.temperatures));
  return Json::array({point});
}

Json resends(const PrinterStatus& status) {
  const std::int64_t ratio =
      status.lines_sent > 0 ? 100 * status.resends / status.lines_sent : 0;  // percent
  return {{"count", status.resends}, {"transmitted", status.lines_sent}, {"ratio", ratio}};
}

Json busy_files(const PrinterStatus& status) {
  if (status.job == 0) return Json::array();
  return Json::array({Json{{"origin", "local"}, {"path", status.file}}});
}

}  // namespace

std::string push_connected() {
  return one_line({{"connected",
                    {{"version", kOctoPrintRelease},
                     {"display_version", kOctoPrintRelease},
                     {"branch", "slipstick " SLIPSTICK_VERSION},
                     {"python_version", nullptr},
                     {"plugin_hash", "none"},
                     {"config_hash", "none"},
                     {"debug", false},
                     {"safe_mode", nullptr},
                     {"online", nullptr},
                     {"permissions", Json::array()}}}});
}

std::string push_state(std::string_view kind, const OctoMoment& moment,
                       const std::vector<std::string>& logs) {
  const PrinterStatus& status = moment.status;
  Json state = octo_state_of(status.activity);
  state["error"] = status.activity == PrinterActivity::kStopped ? status.message : "";
  Json body{{"state", std::move(state)},
            {"job", octo_job_of(moment)},
            {"progress", octo_progress(status)},
            {"currentZ", status.job == 0 ? Json() : Json(status.height)},
            {"currentTool", 0},
            {"offsets", Json::object()},
            {"resends", resends(status)},
            {"serverTime", moment.time},
            {"temps", temperature_points(moment)},
            {"logs", logs},
            {"messages", Json::array()},
            {"busyFiles", busy_files(status)},
            {"plugins", Json::object()}};
  return one_line(Json{{std::string(kind), std::move(body)}});
}

std::string sock_js_frame(std::string_view message) {
  return "a" + one_line(Json::array({std::string(message)}));
}

}  // namespace slipstick
