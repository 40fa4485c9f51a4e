// What is asked of a print under way, on the embedded printer in virtual time.
#include <catch2/catch.hpp>

#include "host/stream_job.h"
#include "sim/sim_transport.h"
#include "tests/support/spiral.h"

using namespace slipstick;
using Catch::Contains;

namespace {

// Moves without end, or so many; calls `at` before each.
class Moves final : public LineSource {
 public:
  Moves(int count, std::function<void(int)> at) : count_(count), at_(std::move(at)) {}

  Result<std::optional<Line>> next() override {
    if (given_ == count_) return std::optional<Line>();
    at_(given_);
    ++given_;
    if (given_ == 1) return normalise("M104 S205");
    return normalise(given_ % 2 == 0 ? "G1 X1 F6000" : "G1 X2 F6000");
  }
  bool ready() const override { return true; }
  int given() const { return given_; }

 private:
  int count_;
  std::function<void(int)> at_;
  int given_ = 0;
};

// A printer whose cable can be pulled out, or that hears nothing any more.
class FrailTransport final : public Transport {
 public:
  enum class Fault { kNone, kUnplugged, kMute };
  FrailTransport(SimTransport& sim, const Fault& fault) : sim_(sim), fault_(fault) {}

  Result<std::size_t> read_some(std::span<char> buffer,
                                std::chrono::microseconds patience) override {
    if (fault_ == Fault::kUnplugged) return gone();
    const auto got = sim_.read_some(buffer, patience);
    if (got && fault_ == Fault::kMute) return fail(ErrorCode::kTimedOut, "nothing came");
    return got;
  }
  Result<std::size_t> write_some(std::string_view bytes,
                                 std::chrono::microseconds patience) override {
    if (fault_ == Fault::kUnplugged) return gone();
    if (fault_ == Fault::kMute) return bytes.size();
    return sim_.write_some(bytes, patience);
  }
  Result<void> write_all(std::string_view bytes, std::chrono::microseconds patience) override {
    return sim_.write_all(bytes, patience);
  }
  void shut_down() noexcept override { sim_.shut_down(); }
  std::string_view name() const override { return "frail"; }

 private:
  static tl::unexpected<Error> gone() { return fail(ErrorCode::kUnavailable, "frail: gone"); }

  SimTransport& sim_;
  const Fault& fault_;
};

constexpr ParkingPlace kParking{.x = 5,
                                .y = 215,
                                .height_max = 250,
                                .retraction = 1,
                                .retraction_speed = 30,
                                .travel_speed = 100,
                                .lift_speed = 10};

// What a program lays when it is paused once `line` lines were sent; never if that is negative.
std::vector<test::Bead> beads(const std::vector<std::string>& program, int line) {
  std::vector<test::Bead> beads;
  PrintControl* handle = nullptr;
  int turns = 0;  // while it is held
  PrintControl control({{}, [&](SenderState, const StreamFigures& figures) {
                          if (turns == 0 && static_cast<int>(figures.counters.lines_sent) == line)
                            handle->pause();
                          if (handle->wish() == PrintControl::Wish::kPause && ++turns == 3)
                            handle->resume();
                        }});
  handle = &control;
  SimTransport sim(*sim_options({}), test::into(beads));
  test::ProgramLines lines(program);
  REQUIRE(stream_job(sim, sim.clock(), lines, {Pace::kVirtual, kParking}, control));
  sim.run_down(std::chrono::hours(1));
  CHECK((line < 0 || turns >= 3));
  return beads;
}

double nozzle_target(const SimTransport& sim) {
  return sim.printer().machine().nozzle.target();
}

}  // namespace

TEST_CASE("A cancelled print ends with the heaters off and sends no further line") {
  PrintControl control;
  SimTransport sim(*sim_options({}));
  Moves moves(100'000, [&](int line) {
    if (line == 50) control.cancel();
  });

  const auto outcome = stream_job(sim, sim.clock(), moves, {Pace::kVirtual, {}}, control);

  REQUIRE(!outcome);
  CHECK(outcome.error().code == ErrorCode::kCancelled);
  CHECK(moves.given() <= 52);
  CHECK(nozzle_target(sim) == 0);
}

TEST_CASE("Heaters are said to be off only where the printer has confirmed it") {
  using Fault = FrailTransport::Fault;
  const Fault then = GENERATE(Fault::kNone, Fault::kUnplugged, Fault::kMute);
  Fault fault = Fault::kNone;
  int turns = 0;  // since the request
  PrintControl* handle = nullptr;
  PrintControl control({{}, [&](SenderState, const StreamFigures&) {
                          turns += handle->wish() == PrintControl::Wish::kCancel ? 1 : 0;
                          if (turns == 2) fault = then;
                        }});
  handle = &control;
  SimTransport sim(*sim_options({}));
  FrailTransport frail(sim, fault);
  Moves moves(100'000, [&](int line) {
    if (line == 50) control.cancel();
  });

  const auto outcome = stream_job(frail, sim.clock(), moves, {Pace::kVirtual, {}}, control);

  REQUIRE(!outcome);
  CHECK(outcome.error().code == ErrorCode::kCancelled);
  CHECK_THAT(outcome.error().message, Contains("cancelled"));
  const bool off = outcome.error().message.find("heaters are off") != std::string::npos;
  const bool maybe_hot = outcome.error().message.find("may still be on") != std::string::npos;
  CHECK(off == (then == Fault::kNone));
  CHECK(maybe_hot == (then != Fault::kNone));
  CHECK((!off || nozzle_target(sim) == 0));
}

TEST_CASE("A paused print sends nothing until it is resumed, and then everything") {
  int turns_paused = 0;
  int given_while_paused = 0;
  Moves moves(60, [](int) {});
  PrintControl* handle = nullptr;
  PrintControl control({{}, [&](SenderState, const StreamFigures& figures) {
                          if (figures.counters.lines_sent == 30 && turns_paused == 0)
                            handle->pause();
                          if (handle->wish() != PrintControl::Wish::kPause) return;
                          if (turns_paused == 0) given_while_paused = moves.given();
                          CHECK(moves.given() == given_while_paused);
                          if (++turns_paused == 6) handle->resume();
                        }});
  handle = &control;
  SimTransport sim(*sim_options({}));

  const auto outcome = stream_job(sim, sim.clock(), moves, {Pace::kVirtual, {}}, control);

  REQUIRE(outcome);
  CHECK(turns_paused == 6);
  CHECK(outcome->counters.lines_acknowledged == 60);
}

TEST_CASE("A print paused at any line lays the very same beads") {
  const std::string extrusion = GENERATE("M82", "M83");
  const std::vector<std::string> program = test::spiral(extrusion);
  const auto expected = beads(program, -1);
  REQUIRE(expected.size() == 40);

  for (int line = 0; line < static_cast<int>(program.size()); ++line) {
    INFO("paused at line " << line << " with " << extrusion);
    CHECK(beads(program, line) == expected);
  }
}

TEST_CASE("A print cancelled while it is parked ends with the heaters off") {
  PrintControl* handle = nullptr;
  int turns = 0;  // while it is held
  PrintControl control({{}, [&](SenderState, const StreamFigures& figures) {
                          if (figures.counters.lines_sent == 8) handle->pause();
                          if (handle->wish() != PrintControl::Wish::kPause) return;
                          if (++turns == 40) handle->cancel();
                        }});
  handle = &control;
  SimTransport sim(*sim_options({}));
  test::ProgramLines lines(test::spiral("M83"));

  const auto outcome = stream_job(sim, sim.clock(), lines, {Pace::kVirtual, kParking}, control);

  REQUIRE(!outcome);
  CHECK_THAT(outcome.error().message, Contains("cancelled; heaters are off"));
  CHECK(sim.printer().machine().position.x == kParking.x);
  CHECK(nozzle_target(sim) == 0);
}

TEST_CASE("An emergency stop kills the printer at once") {
  PrintControl control;
  SimTransport sim(*sim_options({}));
  Moves moves(100'000, [&](int line) {
    if (line == 50) control.emergency_stop();
  });

  const auto outcome = stream_job(sim, sim.clock(), moves, {Pace::kVirtual, {}}, control);

  REQUIRE(!outcome);
  CHECK_THAT(outcome.error().message, Contains("emergency stop"));
  CHECK(sim.printer().machine().halted);
  CHECK(nozzle_target(sim) == 0);
}

TEST_CASE("A wish never takes a more urgent one back") {
  PrintControl control;

  control.cancel();

  CHECK(!control.pause());
  CHECK(!control.resume());
  CHECK(control.wish() == PrintControl::Wish::kCancel);
  control.emergency_stop();
  control.cancel();
  CHECK(control.wish() == PrintControl::Wish::kEmergencyStop);
}

TEST_CASE("A listener hears temperatures and progress") {
  bool temperatures = false;
  std::uint64_t lines = 0;
  PrintControl control(
      {[&](const SenderEvent& e) { temperatures |= std::holds_alternative<TemperaturesSeen>(e); },
       [&](SenderState, const StreamFigures& figures) {
         lines = figures.counters.lines_acknowledged;
       }});
  SimTransport sim(*sim_options({}));
  Moves moves(200, [](int) {});

  REQUIRE(stream_job(sim, sim.clock(), moves, {Pace::kVirtual, {}}, control));

  CHECK(temperatures);
  CHECK(lines == 200);
}
