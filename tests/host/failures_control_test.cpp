// Pauses, stops and complaints from either end of the cable, in virtual time.
#include <catch2/catch.hpp>

#include "tests/host/recorded_print.h"

using namespace slipstick;
using Catch::Contains;
using namespace std::chrono_literals;

namespace {

constexpr int kMoves = 300;

// A control that does `deed` once so many lines were sent.
class At {
 public:
  At(std::uint64_t line, std::function<void(PrintControl&)> deed)
      : control_({{},
                  [this, line](SenderState, const StreamFigures& figures) {
                    if (done_ || figures.counters.lines_sent < line) return;
                    done_ = true;
                    deed_(control_);
                  }}),
        deed_(std::move(deed)) {}
  PrintControl& control() { return control_; }

 private:
  PrintControl control_;
  std::function<void(PrintControl&)> deed_;
  bool done_ = false;
};

// The longest time between two writes, and when it began.
struct Gap {
  Moment from{}, lasts{};
};
Gap longest_gap(const test::Recorded& print) {
  Gap gap;
  for (std::size_t i = 1; i < print.writes.size(); ++i) {
    const Moment lasts = print.writes[i].at - print.writes[i - 1].at;
    if (lasts > gap.lasts) gap = {print.writes[i - 1].at, lasts};
  }
  return gap;
}

bool wrote(const test::Recorded& print, const std::string& text) {
  return std::ranges::any_of(
      print.writes, [&](const auto& write) { return write.bytes.find(text) != std::string::npos; });
}

std::vector<Vec3> whole() {
  return test::print_recorded(test::cold_program(kMoves), {}).places;
}

// With a place to come back to.
std::vector<std::string> placed_program() {
  auto program = test::cold_program(kMoves);
  program.insert(program.begin() + 3, "G1 X1 Y1 Z1 F6000");
  return program;
}

std::string printer_asks(const std::string& action, const std::string& when) {
  return "say=//action:" + action + "@" + when;
}

// Says that it was stopped and then goes on as if it were not.
class LyingBoard final : public Transport {
 public:
  class Time final : public Clock {
   public:
    Moment now() const override { return now_; }
    void pass(Moment time) { now_ += time; }

   private:
    Moment now_{};
  };

  explicit LyingBoard(bool goes_on) : goes_on_(goes_on) {}

  Result<std::size_t> read_some(std::span<char> buffer,
                                std::chrono::microseconds patience) override {
    if (said_.empty()) {
      time_.pass(patience);
      return fail(ErrorCode::kTimedOut, "nothing");
    }
    const std::size_t line = said_.find('\n') + 1;  // one at a time
    const std::size_t count = std::min(buffer.size(), line);
    std::copy_n(said_.begin(), count, buffer.begin());
    said_.erase(0, count);
    return count;
  }
  Result<std::size_t> write_some(std::string_view bytes, std::chrono::microseconds) override {
    if (bytes.find("M112") != std::string_view::npos) {
      said_ += "Error:Printer halted. kill() called!\n";
      if (goes_on_) said_ += "ok\nok\n";
    }
    return bytes.size();
  }
  Result<void> write_all(std::string_view, std::chrono::microseconds) override { return {}; }
  bool set_dtr(bool on) noexcept override {
    resets_ += on ? 0 : 1;
    return true;
  }
  void shut_down() noexcept override {}
  std::string_view name() const override { return "lying"; }

  const Time& time() const { return time_; }
  int resets() const { return resets_; }

 private:
  Time time_;
  std::string said_;
  bool goes_on_;
  int resets_ = 0;
};

}  // namespace

TEST_CASE("Whoever cancels during a heat-up need not wait for the heat") {
  At at(2, [](PrintControl& control) { control.cancel(); });
  const auto print = test::print_recorded({"M140 S60", "M190 S60", "G1 X9"}, {}, at.control());

  CHECK_THAT(print.message(), Contains("cancelled; heaters are off"));
  CHECK(print.ended < 10s);
  CHECK(print.places.empty());
  CHECK_FALSE(print.heats);
}

TEST_CASE("Cancelled at any line, even before the first, a print ends at once and cold") {
  for (std::uint64_t line = 0; line < 30; ++line) {
    INFO(line);
    At at(line, [](PrintControl& control) {
      control.pause();
      control.resume();
      control.cancel();
    });
    auto program = test::cold_program(60);
    program.insert(program.begin(), {"M104 S100", "M140 S40"});
    const auto print = test::print_recorded(program, {}, at.control());

    CHECK_THAT(print.message(), Contains("cancelled; heaters are off"));
    CHECK_FALSE(print.heats);
    CHECK(print.places.size() <= line);
    CHECK(print.ended < 10s);
  }
}

TEST_CASE("A board that is reset while a print is cancelled does not hold the end up") {
  for (const char* fault : {"reset", "silent-reset", "freeze", "kill"}) {
    INFO(fault);
    At at(46, [](PrintControl& control) { control.cancel(); });
    const auto print = test::print_recorded(
        test::cold_program(kMoves), {{"fault", std::string(fault) + "@line51"}}, at.control());

    CHECK_THAT(print.message(), Contains("cancelled"));
    CHECK(print.ended < 1min);
  }
}

TEST_CASE("A pause in the middle of requests to send again loses nothing") {
  for (std::uint64_t line = 20; line < 45; line += 3) {
    INFO(line);
    int turns = 0;
    PrintControl* handle = nullptr;
    PrintControl control({{}, [&](SenderState state, const StreamFigures& figures) {
                            const bool resends = state == SenderState::kResending;
                            if (turns == 0 && figures.counters.lines_sent >= line && resends)
                              handle->pause();
                            if (handle->wish() == PrintControl::Wish::kPause && ++turns == 50)
                              handle->resume();
                          }});
    handle = &control;
    const auto print = test::print_recorded(test::spiral("M83"),
                                            {{"fault", "flip-rx=0.005"}, {"seed", "3"}}, control);

    INFO(print.message());
    REQUIRE(print.outcome);
    CHECK(turns >= 50);
    CHECK(print.outcome->counters.lines_acknowledged == test::spiral("M83").size());
  }
}

TEST_CASE("What a printer says while a print is paused is read") {
  int heard = 0;
  PrintControl* handle = nullptr;
  PrintControl control({[&](const SenderEvent& event) {
                          const bool paused = handle->wish() == PrintControl::Wish::kPause;
                          if (!paused || !std::holds_alternative<TemperaturesSeen>(event)) return;
                          if (++heard == 100) handle->resume();
                        },
                        [&](SenderState, const StreamFigures& figures) {
                          if (heard == 0 && figures.counters.lines_sent >= 50) handle->pause();
                        }});
  handle = &control;

  const auto print = test::print_recorded(test::cold_program(kMoves), {}, control);

  CHECK(print.outcome);
  CHECK(heard >= 100);
}

TEST_CASE("A printer that asks for a pause is parked, and goes on when it asks for that") {
  const auto program = placed_program();
  const std::string pause = printer_asks("pause filament_runout 0", "line50");
  const auto print =
      test::print_recorded(program, {{"fault", pause + "," + printer_asks("resume", "60")}});

  REQUIRE(print.outcome);
  CHECK(longest_gap(print).lasts > 30s);
  CHECK(wrote(print, "G0 X5 Y215"));
  CHECK(print.outcome->counters.lines_acknowledged == program.size());
}

TEST_CASE("A printer that has paused by itself hears nothing until it says that it has resumed") {
  const auto print = test::print_recorded(
      placed_program(),
      {{"fault", printer_asks("paused", "line50") + "," + printer_asks("resumed", "60")}});

  REQUIRE(print.outcome);
  const Gap gap = longest_gap(print);
  CHECK(gap.lasts > 30s);
  CHECK(gap.from + gap.lasts >= 60s);
  CHECK_FALSE(wrote(print, "G0 X5 Y215"));
  CHECK(print.places == test::print_recorded(placed_program(), {}).places);
}

TEST_CASE("A print that is cancelled at the printer ends cold, also while it is paused") {
  const bool paused = GENERATE(false, true);
  auto program = test::cold_program(kMoves);
  program.insert(program.begin(), "M104 S100");
  std::string fault = printer_asks("cancel", paused ? "60" : "line50");
  if (paused) fault += "," + printer_asks("pause", "line50");
  const auto print = test::print_recorded(program, {{"fault", fault}});

  CHECK_THAT(print.message(), Contains("cancelled at the printer; heaters are off"));
  CHECK_FALSE(print.heats);
}

TEST_CASE("Plastic that is not pushed and moves that are not made pause the print, once") {
  const auto* words = GENERATE("echo: cold extrusion prevented", "echo:Home XYZ First",
                               "Error:G2/G3 bad parameters", "echo:T3 Invalid extruder");
  int pauses = 0;
  PrintControl* handle = nullptr;
  PrintControl control({{}, [&](SenderState, const StreamFigures&) {
                          if (handle->wish() != PrintControl::Wish::kPause) return;
                          ++pauses;
                          handle->resume();
                        }});
  handle = &control;
  const std::string say = std::string("say=") + words;
  const auto print = test::print_recorded(test::cold_program(kMoves),
                                          {{"fault", say + "@line50," + say + "@line52"}}, control);

  REQUIRE(print.outcome);
  CHECK(pauses >= 1);
  CHECK(print.outcome->not_done == 2);
}

TEST_CASE("Where nobody can look, what was not done ends the print") {
  SimTransport sim(*sim_options({}));
  test::ProgramLines lines({"M83", "G1 X10 E1", "G1 X20 E1", "G1 X30 E1"});
  const auto outcome = stream_job(sim, sim.clock(), lines, {Pace::kVirtual, {}});

  REQUIRE(!outcome);
  CHECK_THAT(outcome.error().message,
             Contains("cold extrusion prevented") && Contains("heaters are off"));
}

TEST_CASE("Commands that the printer does not know are counted, and the print goes on") {
  auto program = test::cold_program(kMoves);
  program.insert(program.begin() + 50, {"M12345 S1", "G99", "M12345 S2"});
  const auto print = test::print_recorded(program, {});

  REQUIRE(print.outcome);
  CHECK(print.outcome->unknown_commands == 3);
  CHECK(print.places == whole());
}

TEST_CASE("A sensor that cannot be right ends the print with the heaters off") {
  const auto* reading = GENERATE("T:nan /200.00 B:60.00 /60.00", "T:-15.00 /200.00 B:60.00 /60.00",
                                 "T:inf /200.00 B:60.00 /60.00");
  const std::string say = std::string("say=") + reading;
  auto program = test::cold_program(kMoves);
  program.insert(program.begin(), "M104 S100");
  const auto print = test::print_recorded(
      program, {{"fault", say + "@line50," + say + "@line51," + say + "@line52"}});

  CHECK_THAT(print.message(),
             Contains("the sensor of the nozzle cannot be right") && Contains("heaters are off"));
  CHECK_FALSE(print.heats);
}

TEST_CASE("A board that says it was stopped and goes on is reset") {
  const bool goes_on = GENERATE(false, true);
  LyingBoard board(goes_on);
  test::ProgramLines lines(test::cold_program(10));
  PrintControl control;
  control.emergency_stop();

  const auto outcome = stream_job(board, board.time(), lines, {Pace::kRealTime, {}}, control);

  REQUIRE(!outcome);
  CHECK(board.resets() == (goes_on ? 1 : 0));
  CHECK((outcome.error().message.find("switch it off") != std::string::npos) == goes_on);
}

TEST_CASE("Half a line in the board's buffer does not hide an emergency stop") {
  SimTransport sim(*sim_options({}));
  std::array<char, 256> buffer{};
  while (sim.read_some(buffer, 1s)) continue;
  REQUIRE(sim.write_all("N5 G1 X10 Y1", 1s));
  test::ProgramLines lines(test::cold_program(10));
  PrintControl control;
  control.emergency_stop();

  REQUIRE(!stream_job(sim, sim.clock(), lines, {Pace::kRealTime, {}}, control));

  CHECK(sim.printer().machine().halted);
}
