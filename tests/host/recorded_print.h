#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/stream_job.h"
#include "sim/sim_transport.h"
#include "tests/support/spiral.h"

namespace slipstick::test {

/// The simulated printer's transport, and what was written to it when.
class RecordedTransport final : public Transport {
 public:
  struct Write {
    Moment at;
    std::string bytes;
  };

  explicit RecordedTransport(SimTransport& sim) : sim_(sim) {}

  Result<std::size_t> read_some(std::span<char> buffer,
                                std::chrono::microseconds patience) override {
    if (sim_.clock().now() > kLongest) return fail(ErrorCode::kUnavailable, "it takes for ever");
    return sim_.read_some(buffer, patience);
  }
  Result<std::size_t> write_some(std::string_view bytes,
                                 std::chrono::microseconds patience) override {
    writes_.push_back({sim_.clock().now(), std::string(bytes)});
    return sim_.write_some(bytes, patience);
  }
  Result<void> write_all(std::string_view bytes, std::chrono::microseconds patience) override {
    return sim_.write_all(bytes, patience);
  }
  void shut_down() noexcept override { sim_.shut_down(); }
  std::string_view name() const override { return "recorded"; }

  [[nodiscard]] const std::vector<Write>& writes() const { return writes_; }

  /// A print that nobody lets go on would never end.
  static constexpr Moment kLongest = std::chrono::hours(2);

 private:
  SimTransport& sim_;
  std::vector<Write> writes_;
};

/// What came of a print.
struct Recorded {
  Result<StreamOutcome> outcome;
  std::vector<RecordedTransport::Write> writes;
  std::vector<Vec3> places;  ///< Where each move ended.
  bool heats = false;        ///< Whether the firmware has a target.
  Moment ended{};            ///< When the host had done with it.
  std::int64_t faults = 0;

  [[nodiscard]] std::string message() const { return outcome ? "" : outcome.error().message; }
};

/// Prints `program` on the printer of these options, as a host does that has a person at hand, but
/// in virtual time.
inline Recorded print_recorded(const std::vector<std::string>& program,
                               const std::map<std::string, std::string>& printer,
                               PrintControl& control) {
  std::vector<Vec3> places;
  SimTransport sim(sim_options(printer).value(),
                   [&](const ExecutedMove& move) { places.push_back(move.to.xyz()); });
  RecordedTransport recorded(sim);
  ProgramLines lines(program);
  const ParkingPlace parking{.x = 5,
                             .y = 215,
                             .height_max = 250,
                             .retraction = 1,
                             .retraction_speed = 30,
                             .travel_speed = 100,
                             .lift_speed = 10};
  auto outcome = stream_job(recorded, sim.clock(), lines, {Pace::kRealTime, parking}, control);
  const Moment ended = sim.clock().now();
  sim.run_down(std::chrono::minutes(1));
  const Machine& machine = sim.printer().machine();
  return {std::move(outcome),
          recorded.writes(),
          places,
          !machine.nozzle.off() || !machine.bed.off(),
          ended,
          sim.printer().statistics().faults};
}

inline Recorded print_recorded(const std::vector<std::string>& program,
                               const std::map<std::string, std::string>& printer) {
  PrintControl control;
  return print_recorded(program, printer, control);
}

/// Moves that no two of which end at the same place, relative extrusion, no heat.
inline std::vector<std::string> cold_program(int moves) {
  std::vector<std::string> lines{"M302 S0", "M83", "G92 E0"};
  for (int i = 0; i < moves; ++i) {
    lines.push_back("G1 X" + std::to_string(1 + i % 7) + " Y" + std::to_string(1 + i / 7) +
                    " E0.01 F12000");
  }
  return lines;
}

}  // namespace slipstick::test
