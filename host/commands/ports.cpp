// `slipstick ports`: where a printer may be connected.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/commands/command.h"
#include "host/ports_json.h"

namespace slipstick {
namespace {

CommandResult run_ports(bool json) {
  const auto ports = list_serial_ports();
  if (!ports) return fail(ports.error());
  if (json) {
    std::cout << to_json(*ports).dump(2) << '\n';
    return 0;
  }
  for (const SerialPort& port : *ports) {
    fmt::print("{:<16} {:<10} {} {}\n", port.path, usb_text(port), port.product,
               port.serial_number);
  }
  if (ports->empty()) fmt::print("no serial ports\n");
  return 0;
}

}  // namespace

void add_ports_command(CLI::App& app, ChosenCommand& run) {
  const auto json = std::make_shared<bool>(false);
  CLI::App* sub = app.add_subcommand("ports", "serial ports of this machine");
  sub->add_flag("--json", *json, "print as JSON");
  sub->footer("Example: slipstick ports");
  sub->callback([json, &run] { run = [json] { return run_ports(*json); }; });
}

}  // namespace slipstick
