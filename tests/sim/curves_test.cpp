#include "sim/curves.h"

#include <catch2/catch.hpp>

using namespace slipstick;

namespace {

Moment at(double seconds) {
  return Moment(static_cast<Moment::rep>(seconds * 1e6));
}

double way_of(const Curves& curves) {
  double way = 0;
  for (const auto& sample : curves.samples()) way += sample.way;
  return way;
}

}  // namespace

TEST_CASE("A move is spread over the spans that it takes") {
  Curves curves;
  curves.add({{0, 0, 0, 0}, {30, 0, 0, 1}, 10, 0.5, 3.5});

  REQUIRE(curves.samples().size() == 4);
  CHECK(curves.samples()[0].way == Approx(5));
  CHECK(curves.samples()[1].way == Approx(10));
  CHECK(curves.samples()[3].way == Approx(5));
  CHECK(curves.samples()[2].speed_max == Approx(10));
}

TEST_CASE("A span is as hot as it was last seen, and one that was not seen as the one before") {
  Machine machine(MachineOptions{}, {});
  Curves curves;
  machine.nozzle.set_target(200);
  machine.advance(at(20));
  curves.see(at(2.5), machine);
  curves.see(at(5.5), machine);

  REQUIRE(curves.samples().size() == 6);
  CHECK(curves.samples()[1].nozzle == Heater::kRoomCelsius);
  CHECK(curves.samples()[2].nozzle > 80);
  CHECK(curves.samples()[4].nozzle == curves.samples()[2].nozzle);
  CHECK(curves.samples()[4].nozzle_target == 200);
}

TEST_CASE("However long the print, there are no more samples, and no way is lost") {
  Machine machine(MachineOptions{}, {});
  Curves curves;
  for (int i = 0; i < 50'000; ++i) {
    curves.add({{0, 0, 0, 0}, {1, 0, 0, 0}, 1, i + 0.0, i + 1.0});
    curves.see(at(i + 1.0), machine);
    REQUIRE(curves.samples().size() <= Curves::kSamplesMax);
  }

  CHECK(way_of(curves) == Approx(50'000));
  CHECK(curves.span_seconds() == 64);
  CHECK(curves.samples()[10].way == Approx(64));
}

TEST_CASE("What did not move adds nothing") {
  Curves curves;
  curves.add({{0, 0, 0, 0}, {0, 0, 0, 5}, 10, 0, 2});

  CHECK(curves.samples().empty());
}
