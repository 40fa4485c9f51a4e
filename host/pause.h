#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "core/job/settings.h"
#include "drivers/marlin/park.h"
#include "host/print_control.h"

namespace slipstick {

/// The rear left corner of the bed, at the speeds of the print.
[[nodiscard]] ParkingPlace parking_place(const PrintSettings& settings);

/// Holds a print while it is wished to: the nozzle is parked, and brought back before the print
/// goes on. Pure: wishes and lines in, lines out.
class Pause {
 public:
  /// kStay: the printer has parked by itself, or waits to be let; whatever it is sent would block.
  enum class Manner : std::uint8_t { kPark, kStay };

  /// Without a place to park, the nozzle stays where it is.
  /// \param state what was sent before the job; \param first what is sent before its first line.
  Pause(const std::optional<ParkingPlace>& place, PrintStateTracker state,
        const std::vector<Line>& first)
      : place_(place), tracker_(std::move(state)), lines_(first.begin(), first.end()) {}

  /// What is wished now. \return whether the print begins to be held, or begins to go on.
  bool heed(PrintControl::Wish wish, Manner manner = Manner::kPark);

  /// `line` is sent: of the job, which it may be while nothing holds it, or one that leaves the
  /// nozzle where it is.
  void follow(const Line& line) { tracker_.follow(line.text()); }

  /// What has to be sent before anything of the job; nothing if there is nothing (left).
  [[nodiscard]] std::optional<Line> next();

  /// Nothing of the job may be sent now.
  [[nodiscard]] bool holds() const { return held_ || !lines_.empty(); }
  [[nodiscard]] bool wanted() const { return held_; }

 private:
  const std::optional<ParkingPlace> place_;
  PrintStateTracker tracker_;
  std::deque<Line> lines_;
  bool held_ = false;
  bool parked_ = false;
};

}  // namespace slipstick
