// Every fault of the simulated printer against the host: the print is what it was to be, or it ends
// with a reason, is a beginning of it, and heaters are called off only where they are.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>

#include "host/stream_job.h"
#include "sim/faults/fault_names.h"
#include "sim/sim_transport.h"

using namespace slipstick;

namespace {

constexpr int kMoves = 400;

/// Heats, moves to and fro with a thread of plastic, cools down.
class Job final : public LineSource {
 public:
  Result<std::optional<Line>> next() override {
    constexpr std::array kBefore{"M140 S50", "M109 S200", "M83"};
    constexpr std::array kAfter{"M104 S0", "M140 S0"};
    const int i = given_++;
    const int move = i - static_cast<int>(kBefore.size());
    if (move < 0) return normalise(kBefore[static_cast<std::size_t>(i)]);
    if (move < kMoves) {
      return normalise("G1 X" + std::to_string(1 + move % 7) + " Y" + std::to_string(move % 11) +
                       " E0.01 F6000");
    }
    const auto after = static_cast<std::size_t>(move - kMoves);
    if (after >= kAfter.size()) return std::optional<Line>();
    return normalise(kAfter[after]);
  }
  bool ready() const override { return true; }

 private:
  int given_ = 0;
};

struct Printed {
  Result<StreamOutcome> outcome;
  std::vector<Vec3> places;  ///< Where each move ended.
  bool heats = false;        ///< Whether the firmware has a target.
  std::int64_t faults = 0;
};

Printed print_with(const std::string& fault) {
  std::vector<Vec3> places;
  std::map<std::string, std::string> address{{"seed", "3"}};
  if (!fault.empty()) address["fault"] = fault;
  SimTransport sim(sim_options(address).value(),
                   [&places](const ExecutedMove& move) { places.push_back(move.to.xyz()); });
  Job job;
  auto outcome = stream_job(sim, sim.clock(), job, {Pace::kVirtual, {}});
  sim.run_down(std::chrono::minutes(1));
  const Machine& machine = sim.printer().machine();
  return {std::move(outcome), places, !machine.nozzle.off() || !machine.bed.off(),
          sim.printer().statistics().faults};
}

/// What must come of a fault: the whole print, or an end whose reason has these words.
struct Expectation {
  const char* fault;
  const char* words = "";
};

constexpr const char* kReset = "was reset";
constexpr const char* kStopped = "the printer stopped itself: Printer halted";

constexpr auto kExpectations = std::to_array<Expectation>({
    {"flip-rx"},
    {"flip-tx"},
    {"lose-rx"},
    {"lose-tx"},
    {"double-rx"},
    {"double-tx"},
    {"lose-line-rx=0.05"},
    {"double-line-rx=0.05"},
    {"garble-line-rx=0.05"},
    {"lose-line-tx=0.05"},
    {"double-line-tx=0.05"},
    {"garble-line-tx=0.05"},
    {"glue-tx=0.05"},
    {"lose-ok=0.05"},
    {"double-ok=0.05"},
    {"garble-ok=0.05"},
    {"lose-resend,flip-rx"},
    {"double-resend,flip-rx"},
    {"wrong-resend,flip-rx"},
    {"late=0.5@line50"},
    {"mute=5@line50"},
    {"deaf=5@line50"},
    {"deaf=90@line50"},
    {"freeze=5@line50"},
    {"mute@line50", "has not answered"},
    {"freeze@line50", "has not answered"},
    {"unplug@line50", "the cable is out"},
    {"unplug=1@line50", "the cable is out"},
    {"reset@line50", kReset},
    {"silent-reset@line50", kReset},
    {"brown-out@line50", kReset},
    {"watchdog@line50", kReset},
    {"kill@line50", kStopped},
    {"say=ok@line50"},
    {"say=start@line50", kReset},
    {"hear=AT@line50"},
    {"hear=M112@line50", kStopped},
    {"nozzle-open@line50", "MINTEMP triggered, system stopped! Heater_ID: E0"},
    {"nozzle-short@line50", "MAXTEMP triggered, system stopped! Heater_ID: E0"},
    {"nozzle-cold@1", "Heating failed, system stopped! Heater_ID: E0"},
    {"nozzle-stuck@1", "MAXTEMP triggered, system stopped! Heater_ID: E0"},
    {"bed-open@line50", "MINTEMP triggered, system stopped! Heater_ID: bed"},
    {"bed-short@line50", "MAXTEMP triggered, system stopped! Heater_ID: bed"},
    {"bed-cold@1", "Heating failed, system stopped! Heater_ID: bed"},
    {"bed-stuck@1"},  // What heats beyond 150 °C only after the end of this print.
    {"runout@line50"},
});

bool is_beginning(const std::vector<Vec3>& part, const std::vector<Vec3>& whole) {
  return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

bool has(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("Whatever goes wrong with the printer, the print is right or ends with a reason") {
  const Printed whole = print_with("");
  REQUIRE(whole.outcome);
  REQUIRE(whole.places.size() == kMoves);
  for (const auto& [fault, words] : kExpectations) {
    const Printed printed = print_with(fault);
    const std::string message = printed.outcome ? "" : printed.outcome.error().message;
    INFO(fault << ": " << message);
    CHECK(printed.faults > 0);
    CHECK(printed.outcome.has_value() == std::string(words).empty());
    CHECK(has(message, words));
    CHECK(is_beginning(printed.places, whole.places));
    if (printed.outcome) CHECK(printed.places.size() == whole.places.size());
    if (printed.heats) CHECK(has(message, "heaters may still be on"));
  }
}

TEST_CASE("No fault is left out above") {
  for (const FaultName& name : fault_names()) {
    const auto is_of_it = [&](const Expectation& expectation) {
      const std::string_view fault = expectation.fault;
      return fault.substr(0, fault.find_first_of("=@,")) == name.name;
    };
    INFO(name.name);
    CHECK(std::any_of(kExpectations.begin(), kExpectations.end(), is_of_it));
  }
}

TEST_CASE("Faults in the address of a printer that cannot be are refused with what can") {
  const auto options = sim_options({{"fault", "lose-ok=0.1,flop"}});

  REQUIRE_FALSE(options);
  CHECK(has(options.error().message, "fault 'flop'"));
  CHECK(has(options.error().message, "silent-reset"));
}
