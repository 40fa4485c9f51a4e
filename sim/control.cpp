#include "sim/control.h"

#include <fmt/format.h>

#include <array>
#include <chrono>

namespace slipstick {

namespace {

constexpr std::string_view kFault = "fault ";

std::string state_of(const Printer& printer) {
  const Machine& m = printer.machine();
  const Axes at = m.planner.position(printer.now());
  const PrinterStatistics s = printer.statistics();
  return fmt::format(
      R"({{"seconds":{:.3f},"x":{:.3f},"y":{:.3f},"z":{:.3f},"e":{:.3f},"queued":{},)"
      R"("nozzle":{:.2f},"nozzle_target":{:.2f},"bed":{:.2f},"bed_target":{:.2f},"fan":{},)"
      R"("halted":{},"plugged":{},"lines":{},"resends":{},"faults":{}}})",
      std::chrono::duration<double>(printer.now()).count(), at.x, at.y, at.z, at.e,
      m.planner.queued(), m.nozzle.true_celsius(), m.nozzle.target(), m.bed.true_celsius(),
      m.bed.target(), m.fan, m.halted, printer.plugged(), s.lines_accepted, s.resends_requested,
      s.faults);
}

std::string suffer(Printer& printer, std::string_view text) {
  const auto spec = FaultSpec::parse(text);
  if (!spec) return "error: " + spec.error().message;
  const auto suffered = printer.suffer(*spec);
  return suffered ? "ok" : "error: " + suffered.error().message;
}

}  // namespace

std::string obey_control(Printer& printer, std::string_view line) {
  if (line.starts_with(kFault)) return suffer(printer, line.substr(kFault.size()));
  if (line == "mend") {
    printer.mend();
  } else if (line == "press") {
    printer.press_button();
  } else if (line == "reset") {
    printer.reset(ResetCause::kButton);
  } else if (line == "state") {
    return state_of(printer);
  } else {
    return fmt::format("error: no command '{}': there are fault, mend, press, reset, state", line);
  }
  return "ok";
}

}  // namespace slipstick
