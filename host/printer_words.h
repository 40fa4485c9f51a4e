#pragma once

#include <cstdint>
#include <string>

#include "drivers/marlin/sender_events.h"
#include "drivers/marlin/sensor_watch.h"

namespace slipstick {

/// What a printer's own words ask of the print under way: its buttons and its filament sensor speak
/// by `//action:`, its complaints and readings may be a reason to wait, or to end.
class PrinterWords {
 public:
  enum class Wish : std::uint8_t {
    kNone,
    kPause,   ///< Park and wait.
    kHold,    ///< The printer has parked itself: wait, and say nothing meanwhile.
    kGoOn,    ///< The pause is over.
    kCancel,  ///< Somebody has cancelled at the printer.
    kWait,    ///< Something was not done: pause, so that somebody can look.
    kEnd,     ///< It is not safe to go on.
  };
  struct Heard {
    Wish wish = Wish::kNone;
    std::string reason;  ///< Of kWait and kEnd, for a person.
  };

  [[nodiscard]] Heard hear(const SenderEvent& event);

  /// Commands that were acknowledged but not done, and not known.
  [[nodiscard]] std::uint64_t not_done() const { return not_done_; }
  [[nodiscard]] std::uint64_t unknown() const { return unknown_; }

 private:
  Heard hear_message(const std::string& text);

  SensorWatch sensors_;
  std::uint64_t not_done_ = 0;
  std::uint64_t unknown_ = 0;
};

}  // namespace slipstick
