#include "sim/printer.h"

#include <algorithm>
#include <array>
#include <utility>

namespace slipstick {

namespace {

/// Each direction has its own chance.
constexpr std::uint64_t kOtherDirection = 0x5EED;

}  // namespace

Printer::Printer(const PrinterOptions& options, const Planner::Sink& sink)
    : machine_(std::make_unique<Machine>(options.machine, sink)),
      personality_(options.personality),
      firmware_(std::make_unique<Firmware>(*machine_, personality_, Moment(0))),
      to_board_(options.baud, FaultPlan(options.corrupt, options.seed)),
      to_host_(options.baud, FaultPlan(options.corrupt, options.seed ^ kOtherDirection),
               options.latency),
      faults_(options.faults, options.seed) {}

void Printer::receive(std::string_view bytes, Moment at) {
  if (!plugged_) return;
  const Moment arrives = std::max(at, now_);
  if (faults_.empty()) return to_board_.push(bytes, arrives);
  to_board_.push(faults_.to_board(std::string(bytes), arrives), arrives);
}

Result<void> Printer::suffer(const FaultSpec& fault) {
  return faults_.add(fault.from(now_, firmware_->lines_accepted()));
}

void Printer::kill() {
  firmware_->kill({});
  transmit(firmware_->take_text());
}

void Printer::unplug() {
  plugged_ = false;
  to_board_.clear();
  to_host_.clear();
}

void Printer::say(std::string_view words) {
  to_host_.push(words, now_);
}

void Printer::break_heater(Heater Machine::*heater, HeaterDefect defect) {
  (*machine_.*heater).suffer(defect);
}

/// A UART pushes what arrives into the ring or loses it; USB waits for room. While the board boots,
/// all is lost.
bool Printer::deliver() {
  RxRing& ring = firmware_->ring();
  std::array<char, RxRing::kSize> buffer{};
  const bool waits = firmware_->booted() && !to_board_.paced();
  const std::size_t most = waits ? ring.room() : buffer.size();
  const std::size_t count = to_board_.take(std::span(buffer).first(most), now_);
  for (std::size_t i = 0; firmware_->booted() && i < count; ++i) {
    firmware_->notice(buffer[i]);
    if (!ring.push(buffer[i])) ++bytes_overrun_;
  }
  return count > 0;
}

bool Printer::think() {
  if (!processor_free() || !firmware_->step(now_)) return false;
  if (std::string text = firmware_->take_text(); !text.empty()) transmit(std::move(text));
  return true;
}

/// The processor waits for the transmitter, but not for what is late beyond it.
void Printer::transmit(std::string text) {
  if (!plugged_) return;
  const Moment late = faults_.delay(now_);
  to_host_.push(faults_.to_host(std::move(text), now_), now_ + late);
  busy_until_ = std::max(now_, to_host_.idle_at() - late);
}

/// All that can happen at this moment. Ends because every step consumes bytes, a command or a due
/// time.
void Printer::settle() {
  if (frozen_) {
    machine_->coast(now_);
  } else {
    machine_->advance(now_);
  }
  bool active = true;
  while (active) {
    faults_.see(*this);
    active = false;
    while (deliver()) active = true;
    active = think() || active;
  }
}

std::optional<Moment> Printer::next_event() const {
  std::optional<Moment> first;
  const auto consider = [&](Moment m) { first = first ? std::min(*first, m) : m; };
  if (const auto m = faults_.next_at()) consider(*m);
  if (!frozen_) {
    if (const auto m = firmware_->wakes_at(now_)) consider(std::max(*m, busy_until_));
    if (const auto m = to_board_.next_at(); m && firmware_->reads()) {
      consider(std::max(*m, busy_until_));
    }
  }
  if (!machine_->halted) {
    if (const auto m = machine_->planner.next_event()) consider(*m);
  }
  return first;
}

void Printer::advance(Moment to) {
  while (true) {
    const auto next = next_event();
    if (!next || *next > to) break;
    now_ = std::max(now_, *next);
    settle();
  }
  if (to <= now_) return;
  now_ = to;
  settle();
}

void Printer::reset(ResetCause cause) {
  machine_->reset();
  firmware_ = std::make_unique<Firmware>(*machine_, personality_, now_, cause);
  frozen_ = false;
  busy_until_ = now_;
}

PrinterStatistics Printer::statistics() const {
  return {.motion = machine_->planner.statistics(),
          .lines_accepted = firmware_->lines_accepted(),
          .resends_requested = firmware_->resends_requested(),
          .bytes_overrun = bytes_overrun_,
          .bytes_damaged = to_board_.faults().count() + to_host_.faults().count(),
          .faults = faults_.count()};
}

}  // namespace slipstick
