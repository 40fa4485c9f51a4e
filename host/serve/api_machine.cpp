// What a printer could be connected to, and what is known of it: for the page of the set-up.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "host/config.h"
#include "host/ports_json.h"
#include "host/serve/api.h"

namespace slipstick {
namespace {

// The names that --machine takes.
std::set<std::string> machine_names() {
  std::set<std::string> names;
  const std::filesystem::directory_iterator end;
  for (const auto& folder : config_folders()) {
    std::error_code error;
    std::filesystem::directory_iterator at(folder / "printers", error);
    for (; !error && at != end; at.increment(error)) {
      if (at->path().extension() == ".toml") names.insert(at->path().stem().string());
    }
  }
  return names;
}

bool is_offered(const std::string& port, Services& services) {
  if (port == services.words.port || port == services.printer.port()) return true;
  const auto ports = list_serial_ports();
  return ports && std::ranges::any_of(*ports, [&](const auto& each) { return each.path == port; });
}

}  // namespace

HttpResponse get_machine(const HttpRequest&, Services& services) {
  const auto ports = list_serial_ports();
  const PrinterStatus status = services.board.get();
  return json_response({{"printer", services.printer.port()},
                        {"machine", services.printer.defaults().printer},
                        {"connected", status.connected},
                        {"firmware", status.firmware},
                        {"ports", ports ? to_json(*ports) : nlohmann::ordered_json::array()},
                        {"fault", ports ? "" : ports.error().message},
                        {"machines", machine_names()}});
}

// Nothing but a port of this machine, or what the command line says: no other file is opened.
HttpResponse put_machine(const HttpRequest& request, Services& services) {
  const nlohmann::json json = parse_json(request.body);
  const bool fits = json.is_object() && json.size() == 2 && json.contains("printer") &&
                    json.contains("machine") && json["printer"].is_string() &&
                    json["machine"].is_string();
  if (!fits) return error_response(400, R"(the body is {"printer": PORT, "machine": PROFILE})");
  const PrinterChoice choice{json["printer"], json["machine"]};
  if (!is_offered(choice.port, services))
    return error_response(400, "printer: must be one of the ports of GET machine");
  if (!machine_names().contains(choice.machine))
    return error_response(400, "machine: must be one of the machines of GET machine");
  if (const auto ok = services.printer.use(choice); !ok)
    return error_response(409, ok.error().message);
  const auto kept = services.store.choose_printer(choice, services.words);
  if (!kept) return error_response(kept.error());
  return empty_response();
}

}  // namespace slipstick
