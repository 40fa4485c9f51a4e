// /api/v1/printer/serial-log: what goes over the wire, written down while somebody wants it.
#include <nlohmann/json.hpp>

#include "host/serve/api.h"

namespace slipstick {

HttpResponse get_serial_log(const HttpRequest&, Services& services) {
  return json_response({{"on", services.printer.serial_log().is_on()}});
}

HttpResponse put_serial_log(const HttpRequest& request, Services& services) {
  const nlohmann::json json = parse_json(request.body);
  const bool fits =
      json.is_object() && json.size() == 1 && json.contains("on") && json["on"].is_boolean();
  if (!fits) return error_response(400, R"(the body is {"on": true or false})");
  SerialLog& log = services.printer.serial_log();
  if (!json["on"].get<bool>()) {
    log.stop();
  } else if (const auto ok = log.start(); !ok) {
    return error_response(ok.error());
  }
  return empty_response();
}

HttpResponse get_serial_lines(const HttpRequest&, Services& services) {
  auto text = services.printer.serial_log().tail();
  if (!text) return error_response(text.error());
  return {200, "text/plain; charset=utf-8", *std::move(text), {}};
}

}  // namespace slipstick
