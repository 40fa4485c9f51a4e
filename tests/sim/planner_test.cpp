#include "sim/planner.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/base/rng.h"

using namespace slipstick;

namespace {

constexpr Moment kStart{0};
constexpr Moment kForever{1'000'000'000};

/// 3000 mm/s² and 300 mm/s on X and Y, as Marlin's default configuration.
struct Bench {
  std::vector<ExecutedMove> made;
  MotionLimits limits;
  Planner planner{[this](const ExecutedMove& move) { made.push_back(move); }};

  void add(const Axes& target, double speed, Moment now = kStart) {
    planner.add(target, speed, limits, now);
  }
};

}  // namespace

TEST_CASE("A trapezoid's time is length over speed and a ramp's loss") {
  // v/a to speed up and as much to slow down; each ramp costs v/2a more than cruising: s/v + v/a.
  const Trapezoid t({.length = 60, .entry = 0, .cruise = 60, .exit = 0, .acceleration = 3000});

  CHECK(t.seconds() == Approx(1 + 0.02));
  CHECK(t.distance_at(0.02) == Approx(0.6));  // v²/2a
  CHECK(t.distance_at(t.seconds() / 2) == Approx(30));
}

TEST_CASE("A short move is a triangle") {
  // Half of 0.3 mm at 3000 mm/s²: t = sqrt(2·0.15/3000) = 0.01 s, peak 30 mm/s.
  const Trapezoid t({.length = 0.3, .entry = 0, .cruise = 100, .exit = 0, .acceleration = 3000});

  CHECK(t.peak() == Approx(30));
  CHECK(t.seconds() == Approx(0.02));
}

TEST_CASE("A lone move waits 100 ms for company, three do not wait") {
  Bench lone;
  lone.add({10, 0, 0, 0}, 50);
  lone.planner.advance(kForever);
  CHECK(lone.made.at(0).start_seconds == Approx(0.1));

  Bench three;
  for (int i = 1; i <= 3; ++i) three.add({10.0 * i, 0, 0, 0}, 50, Moment(1'000 * i));
  three.planner.advance(kForever);
  CHECK(three.made.at(0).start_seconds == Approx(0.003));
}

TEST_CASE("Straight on, two moves take as long as one") {
  Bench bench;
  bench.add({30, 0, 0, 0}, 60);
  bench.add({60, 0, 0, 0}, 60);

  bench.planner.advance(kForever);

  CHECK(bench.made.at(1).end_seconds - bench.made.at(0).start_seconds == Approx(1.02));
}

TEST_CASE("A right angle is taken at the speed that junction deviation gives") {
  // cos θ = 0, s = sin 45°. The turn points along (-1, 1)/√2, so that 3000 mm/s² an axis are
  // 3000·√2 along it, but no more than the move's own 3000. v² = 3000 · 0.013 · s / (1 - s) = 39
  // · 2.41421 = 94.154.
  Bench bench;
  bench.add({30, 0, 0, 0}, 60);
  bench.add({30, 30, 0, 0}, 60);

  bench.planner.advance(kForever);

  // Down from 60 to v and up again at 3000 mm/s²: each ramp loses (60 - v)² / (2·60·3000) seconds.
  const double v = std::sqrt(94.154);
  const double ramps = 2 * (60 - v) * (60 - v) / (2 * 60.0 * 3000);
  CHECK(bench.made.at(1).end_seconds - bench.made.at(0).start_seconds ==
        Approx(1.02 + ramps).epsilon(1e-5));
}

TEST_CASE("Turning right back is a stop") {
  Bench bench;
  bench.add({30, 0, 0, 0}, 60);
  bench.add({0, 0, 0, 0}, 60);

  bench.planner.advance(kForever);

  // From 60 to 0.05 mm/s and up again: twice the lone move's 0.52 s but for 0.05 mm/s.
  CHECK(bench.made.at(1).end_seconds - bench.made.at(0).start_seconds ==
        Approx(1.04).epsilon(1e-4));
}

TEST_CASE("No axis goes faster than its limit") {
  Bench bench;
  bench.add({0, 0, 10, 0}, 60);

  bench.planner.advance(kForever);

  CHECK(bench.made.at(0).speed == Approx(5));
  // 10/5 + 5/100
  CHECK(bench.made.at(0).end_seconds - bench.made.at(0).start_seconds == Approx(2.05));
}

TEST_CASE("Moves of less than six steps wait for the next one") {
  Bench bench;
  bench.add({0.05, 0, 0, 0}, 60);
  CHECK(bench.planner.idle());

  bench.add({0.10, 0, 0, 0}, 60);
  bench.planner.advance(kForever);

  REQUIRE(bench.made.size() == 1);
  CHECK(bench.made.at(0).from.x == 0);
  CHECK(bench.made.at(0).to.x == 0.10);
}

TEST_CASE("Fifteen moves fill the planner") {
  Bench bench;
  for (int i = 1; i <= 15; ++i) {
    CHECK_FALSE(bench.planner.full());
    bench.add({1.0 * i, 0, 0, 0}, 1);
  }

  CHECK(bench.planner.full());
}

TEST_CASE("Short moves are stretched while few are queued") {
  // 0.6 mm at 60 mm/s are 10 ms; with 2 queued before it: 10 + 2·(20 - 10)/2 = 20 ms, 30 mm/s.
  Bench bench;
  bench.add({10, 0, 0, 0}, 60);
  bench.add({20, 0, 0, 0}, 60);
  bench.add({20.6, 0, 0, 0}, 60);

  bench.planner.advance(kForever);

  CHECK(bench.made.at(2).speed == Approx(30));
}

TEST_CASE("Whatever comes, the machine stays within speed and acceleration, and all is made") {
  Rng rng(3);
  Bench bench;
  Moment now{0};
  int added = 0;
  Axes at;
  for (int i = 0; i < 3'000; ++i) {
    while (bench.planner.full()) {
      now = *bench.planner.next_event();
      bench.planner.advance(now);
    }
    at = {at.x + 4 * rng.unit() - 2, at.y + 4 * rng.unit() - 2, at.z, at.e + rng.unit() / 10};
    bench.add(at, 1 + 150 * rng.unit(), now);
    ++added;
    if (rng.below(50) == 0) {
      now += Moment(static_cast<Moment::rep>(rng.below(3'000'000)));
      bench.planner.advance(now);
    }
  }
  bench.planner.advance(now + kForever);

  const double slack = 1 + 1e-9;
  double filament = 0;
  for (std::size_t i = 0; i < bench.made.size(); ++i) {
    const ExecutedMove& m = bench.made[i];
    const double mm = length((m.to - m.from).xyz());
    CHECK(m.end_seconds - m.start_seconds >= mm / m.speed / slack);
    CHECK(m.speed <= 300 * std::sqrt(2.0));
    if (i > 0) CHECK(m.start_seconds >= bench.made[i - 1].end_seconds);
    filament += m.filament();
  }
  CHECK(filament == Approx(bench.planner.target().e));
  CHECK(bench.planner.idle());
  CHECK(static_cast<int>(bench.made.size()) <= added);
}

TEST_CASE("Standing without a reason is starvation, resting is not") {
  Bench bench;
  bench.add({10, 0, 0, 0}, 50);
  bench.planner.advance(kForever);
  const double stood_from = bench.planner.statistics().last_move_seconds;
  bench.add({20, 0, 0, 0}, 50, kForever);
  bench.planner.advance(2 * kForever);

  CHECK(bench.planner.statistics().starvations == 1);
  CHECK(bench.planner.statistics().starved_seconds == Approx(1000.1 - stood_from));

  bench.planner.rest();
  bench.add({30, 0, 0, 0}, 50, 2 * kForever);
  bench.planner.advance(3 * kForever);
  CHECK(bench.planner.statistics().starvations == 1);
}
