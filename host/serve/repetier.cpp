// Repetier-Server's API: what slicers ask of it before they upload. There is one printer, and one
// group of models.
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/received_file.h"
#include "host/serve/slicer_hosts.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSlug = "slipstick";  // what the printer is called in addresses

Json printers(const Services& services) {
  const PrinterStatus status = services.board.get();
  const bool online = status.activity != PrinterActivity::kStopped;
  return Json::array({Json{{"name", "slipstick"},
                           {"slug", kSlug},
                           {"active", true},
                           {"online", online ? 1 : 0},
                           {"job", status.job == 0 ? "none" : status.file}}});
}

enum class Then : std::uint8_t { kNothing, kPrint };

HttpResponse take(const HttpRequest& request, Then then, Services& services) {
  if (request.parameter("slug") != kSlug)
    return error_response(404, "there is one printer, slipstick");
  if (form_field(request, "a") != "upload") return error_response(400, "a: upload");
  const ReceivedFile received = receive_form(request, services);
  if (received.refusal) return *received.refusal;
  if (then == Then::kPrint) {
    if (const auto ok = print_file(received.file, services); !ok) return error_response(ok.error());
  }
  return json_response({{"ok", true}, {"file", to_json(received.file)}});
}

}  // namespace

HttpResponse repetier_info(const HttpRequest&, Services& services) {
  return json_response({{"name", "Repetier-Server (slipstick " SLIPSTICK_VERSION ")"},
                        {"version", SLIPSTICK_VERSION},
                        {"software", "slipstick"},
                        {"printers", printers(services)}});
}

HttpResponse repetier_list(const HttpRequest&, Services& services) {
  return json_response({{"data", printers(services)}});
}

// "#" is the group of all that is in no other.
HttpResponse repetier_ask(const HttpRequest& request, Services&) {
  if (request.parameter("slug") != kSlug)
    return error_response(404, "there is one printer, slipstick");
  if (form_field(request, "a") != "listModelGroups") {
    return error_response(400, "a: listModelGroups");
  }
  return json_response({{"groupNames", {"#"}}, {"ok", true}});
}

HttpResponse repetier_upload(const HttpRequest& request, Services& services) {
  return take(request, Then::kNothing, services);
}

HttpResponse repetier_print(const HttpRequest& request, Services& services) {
  return take(request, Then::kPrint, services);
}

}  // namespace slipstick
