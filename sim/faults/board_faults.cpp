#include "sim/faults/board_faults.h"

#include "sim/printer.h"

namespace slipstick {

void Reset::strike(Printer& printer) {
  harm();
  printer.reset(cause_);
}

void Kill::strike(Printer& printer) {
  harm();
  printer.kill();
}

void Freeze::strike(Printer& printer) {
  harm();
  printer.freeze();
}

void Freeze::relent(Printer& printer) {
  printer.thaw();
}

void Unplug::strike(Printer& printer) {
  harm();
  printer.unplug();
}

void Unplug::relent(Printer& printer) {
  printer.plug_in();
}

void Words::strike(Printer& printer) {
  harm();
  if (side_ == WireSide::kToHost) printer.say(words_);
  if (side_ == WireSide::kToBoard) printer.receive(words_, printer.now());
}

void BrokenHeater::strike(Printer& printer) {
  harm();
  printer.break_heater(heater_, defect_);
}

void BrokenHeater::relent(Printer& printer) {
  printer.break_heater(heater_, HeaterDefect::kNone);
}

void NoFilament::strike(Printer& printer) {
  harm();
  printer.run_out_of_filament();
}

void NoFilament::relent(Printer& printer) {
  printer.reload_filament();
}

}  // namespace slipstick
