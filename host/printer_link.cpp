#include "host/printer_link.h"

#include "drivers/open_transport.h"

namespace slipstick {
namespace {

Result<PrinterLink> open_simulator(const TransportAddress& address, Vec3 build_volume,
                                   const Planner::Sink& sink) {
  auto options = sim_options({address.options.begin(), address.options.end()});
  if (!options) return fail(options.error());
  options->printer.machine.build_volume = build_volume;
  auto transport = std::make_unique<SimTransport>(*options, sink);
  SimTransport* sim = transport.get();
  return PrinterLink{std::move(transport), nullptr, &sim->clock(),
                     options->realtime ? Pace::kRealTime : Pace::kVirtual, sim};
}

}  // namespace

Result<PrinterLink> open_printer(std::string_view address, Vec3 build_volume,
                                 const Planner::Sink& sink) {
  const auto parsed = parse_transport_address(address);
  if (!parsed) return fail(parsed.error());
  if (parsed->kind == TransportKind::kSim) return open_simulator(*parsed, build_volume, sink);
  auto transport = open_transport(*parsed);
  if (!transport) return fail(transport.error());
  auto clock = std::make_unique<SteadyClock>();
  const Clock* now = clock.get();
  return PrinterLink{std::move(*transport), std::move(clock), now, Pace::kRealTime, nullptr};
}

}  // namespace slipstick
