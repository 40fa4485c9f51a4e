#include "sim/thermal_guard.h"

#include <catch2/catch.hpp>

#include "tests/sim/dialogue.h"

using namespace slipstick;

namespace {

constexpr Moment kStep{200'000};

/// When, and why, the guard of a heater that suffers `defect` from `from` on stops it.
std::pair<double, std::optional<ThermalAlarm>> run(const HeaterOptions& options,
                                                   const ThermalLimits& limits, double target,
                                                   HeaterDefect defect, double from) {
  Heater heater(options);
  ThermalGuard guard(limits);
  heater.set_target(target);
  for (Moment now{0}; now < Moment(600'000'000); now += kStep) {
    const double seconds = std::chrono::duration<double>(now).count();
    if (seconds >= from) heater.suffer(defect);
    heater.advance(now);
    if (const auto alarm = guard.check(heater, now)) return {seconds, alarm};
  }
  return {600, std::nullopt};
}

auto nozzle(double target, HeaterDefect defect, double from) {
  return run(nozzle_options(), nozzle_limits(), target, defect, from);
}
auto bed(double target, HeaterDefect defect, double from) {
  return run(bed_options(), bed_limits(), target, defect, from);
}

}  // namespace

TEST_CASE("A heater that works is never stopped, whatever its target") {
  for (const double target : {30.0, 60.0, 150.0, 200.0, 260.0}) {
    CHECK_FALSE(nozzle(target, HeaterDefect::kNone, 0).second);
  }
  for (const double target : {30.0, 60.0, 100.0, 120.0}) {
    CHECK_FALSE(bed(target, HeaterDefect::kNone, 0).second);
  }
}

TEST_CASE("A heater that stays cold has failed after its watch, 40 s and 60 s") {
  CHECK(nozzle(200, HeaterDefect::kCold, 0) ==
        std::pair(40.0, std::optional(ThermalAlarm::kHeatingFailed)));
  CHECK(bed(60, HeaterDefect::kCold, 0) ==
        std::pair(60.0, std::optional(ThermalAlarm::kHeatingFailed)));
}

TEST_CASE("A heater that dies when it was hot has run away once it was below for 40 s") {
  const auto [seconds, alarm] = nozzle(100, HeaterDefect::kCold, 100);

  // From 100 °C to below 96 °C takes 95 s · ln(78 / 74) = 5 s.
  CHECK(alarm == ThermalAlarm::kRunaway);
  CHECK(seconds == Approx(145).margin(1));
}

TEST_CASE("A heater that cannot be turned off is stopped above 275 °C, the bed above 150 °C") {
  const auto [seconds, alarm] = nozzle(200, HeaterDefect::kStuck, 0);

  // 22 + 380 (1 - e^(-t / 95 s)) = 275 at 104 s.
  CHECK(alarm == ThermalAlarm::kMaxTemp);
  CHECK(seconds == Approx(104).margin(1));
  CHECK(bed(60, HeaterDefect::kStuck, 0).second == ThermalAlarm::kMaxTemp);
}

TEST_CASE("An open sensor is cold where heat is wanted, a shorted one hot anyhow") {
  CHECK(nozzle(100, HeaterDefect::kSensorOpen, 4) ==
        std::pair(4.0, std::optional(ThermalAlarm::kMinTemp)));
  CHECK_FALSE(nozzle(0, HeaterDefect::kSensorOpen, 4).second);
  CHECK(nozzle(0, HeaterDefect::kSensorShorted, 4).second == ThermalAlarm::kMaxTemp);
  CHECK(bed(60, HeaterDefect::kSensorOpen, 4).second == ThermalAlarm::kMinTemp);
}

TEST_CASE("The board says what is broken, stops and heats no more") {
  Dialogue host;
  host.say("M104 S200");
  host.printer().break_heater(&Machine::nozzle, HeaterDefect::kSensorOpen);

  CHECK(host.listen(kSecond) ==
        "Error:MINTEMP triggered, system stopped! Heater_ID: E0\n\necho:Err: MINTEMP\n"
        "Error:Printer halted. kill() called!\n");
  CHECK(host.printer().machine().nozzle.off());
  CHECK(host.say("M105", 5 * kSecond).empty());
}

TEST_CASE("What is stuck goes on heating though the board has stopped") {
  Dialogue host;
  host.printer().break_heater(&Machine::bed, HeaterDefect::kStuck);
  host.listen(300 * kSecond);
  REQUIRE(host.printer().machine().halted);
  const double before = host.printer().machine().bed.true_celsius();

  host.listen(10 * kSecond);

  CHECK(host.printer().machine().bed.off());
  CHECK(host.printer().machine().bed.true_celsius() > before);
}

TEST_CASE("A heater that has rested is not taken for one that ran away when it heats again") {
  Dialogue host;
  host.say("M109 S200", 300 * kSecond);
  host.say("M104 S0", 600 * kSecond);

  host.say("M104 S200", 60 * kSecond);

  CHECK_FALSE(host.printer().machine().halted);
}
