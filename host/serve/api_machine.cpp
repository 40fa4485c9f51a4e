// What a printer could be connected to, and what is known of it: for the page of the set-up.
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

}  // namespace

HttpResponse get_machine(const HttpRequest&, Services& services) {
  const auto ports = list_serial_ports();
  const PrinterStatus status = services.board.get();
  return json_response({{"printer", services.port},
                        {"machine", services.defaults.printer},
                        {"connected", status.connected},
                        {"firmware", status.firmware},
                        {"ports", ports ? to_json(*ports) : nlohmann::ordered_json::array()},
                        {"fault", ports ? "" : ports.error().message},
                        {"machines", machine_names()}});
}

}  // namespace slipstick
