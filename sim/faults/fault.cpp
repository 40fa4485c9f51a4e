#include "sim/faults/fault.h"

#include "sim/printer.h"

namespace slipstick {

void Fault::see(Printer& printer) {
  if (over_) return;
  if (!begins_ && line_ && printer.lines_accepted() >= *line_) begins_ = printer.now();
  if (!begins_ || printer.now() < *begins_) return;
  if (!struck_) {
    struck_ = true;
    strike(printer);
  }
  if (active(printer.now())) return;
  over_ = true;
  relent(printer);
}

void Fault::end(Printer& printer) {
  if (struck_ && !over_) relent(printer);
  over_ = true;
}

std::optional<Moment> Fault::next_at() const {
  if (!begins_ || over_) return std::nullopt;
  if (!struck_) return begins_;
  return lasts_ ? std::optional(*begins_ + *lasts_) : std::nullopt;
}

}  // namespace slipstick
