#include "host/printer_link.h"

#include "drivers/open_transport.h"

namespace slipstick {
namespace {

Result<PrinterLink> open_simulator(const TransportAddress& address, const PrinterSettings& printer,
                                   const Planner::Sink& sink) {
  auto options =
      sim_options({address.options.begin(), address.options.end()}, machine_like(printer));
  if (!options) return fail(options.error());
  auto transport = std::make_unique<SimTransport>(*options, sink);
  SimTransport* sim = transport.get();
  return PrinterLink{std::move(transport), nullptr, &sim->clock(),
                     options->realtime ? Pace::kRealTime : Pace::kVirtual, sim};
}

}  // namespace

MachineOptions machine_like(const PrinterSettings& printer) {
  const bool round = printer.bed_shape == BedShape::kRound;
  return {
      .build_volume = printer.bed_size,
      .kinematics = Kinematics(round ? Kinematics::Kind::kDelta : Kinematics::Kind::kCartesian)};
}

Result<PrinterLink> open_printer(const TransportAddress& address, const PrinterSettings& printer,
                                 const Planner::Sink& sink) {
  if (address.kind == TransportKind::kSim) return open_simulator(address, printer, sink);
  auto transport = open_transport(address);
  if (!transport) return fail(transport.error());
  auto clock = std::make_unique<SteadyClock>();
  const Clock* now = clock.get();
  return PrinterLink{std::move(*transport), std::move(clock), now, Pace::kRealTime, nullptr};
}

}  // namespace slipstick
