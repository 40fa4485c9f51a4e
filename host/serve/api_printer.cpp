// /api/v1/printer, settings and events.
#include <nlohmann/json.hpp>

#include "core/job/settings_table.h"
#include "host/serve/api.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

HttpResponse done_if(bool applied) {
  return applied ? empty_response() : error_response(409, "no print is under way");
}

}  // namespace

HttpResponse get_printer(const HttpRequest&, Services& services) {
  return json_response(to_json(services.board.get()));
}

HttpResponse get_printed_layer(const HttpRequest&, Services& services) {
  const auto layer = services.board.layer();
  if (!layer) return empty_response();
  return {200, "application/json", to_json_text(*layer), {}};
}

HttpResponse pause_printer(const HttpRequest&, Services& services) {
  return done_if(services.printer.pause());
}

HttpResponse resume_printer(const HttpRequest&, Services& services) {
  return done_if(services.printer.resume());
}

HttpResponse stop_printer(const HttpRequest&, Services& services) {
  const auto told = services.printer.emergency_stop();
  if (!told) return error_response(told.error());
  services.events.publish("emergency", "{}");
  return empty_response();
}

HttpResponse clear_bed(const HttpRequest&, Services& services) {
  if (services.board.get().job != 0) return error_response(409, "a print is under way");
  if (const auto ok = services.store.clear_bed(); !ok) return error_response(ok.error());
  services.printer.wake();
  return empty_response();
}

HttpResponse get_settings(const HttpRequest&, Services& services) {
  const auto settings = load_settings(default_settings(services.printer.defaults()));
  if (!settings) return error_response(settings.error());
  Json list = Json::array();
  for (const SettingGroup group : kSettingGroups) {
    for (const Setting& setting : settings_of(group)) {
      list.push_back({{"key", setting.key},
                      {"group", name_of(group)},
                      {"unit", setting.unit},
                      {"value", toml_value(*settings, setting)},
                      {"help", setting.help}});
    }
  }
  return json_response({{"settings", list}});
}

HttpResponse get_events(const HttpRequest&, Services& services) {
  return {200,
          "text/event-stream",
          "event: state\ndata: " +
              to_json(services.board.get()).dump(-1, ' ', false, Json::error_handler_t::replace) +
              "\n\n",
          {}};
}

}  // namespace slipstick
