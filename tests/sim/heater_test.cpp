#include "sim/heater.h"

#include <catch2/catch.hpp>

#include "tests/sim/dialogue.h"

using namespace slipstick;

TEST_CASE("A cold nozzle at full power warms by what its time constant says") {
  // 22 + 380·(1 - e^(-10/95)) after ten seconds.
  Heater nozzle(nozzle_options());
  nozzle.set_target(260);

  nozzle.advance(10 * kSecond);

  CHECK(nozzle.power() == Heater::kPowerMax);
  CHECK(nozzle.celsius() == Approx(22 + 380 * (1 - std::exp(-10.0 / 95))));
}

TEST_CASE("The nozzle settles at its target with the power that holds it") {
  Heater nozzle(nozzle_options());
  nozzle.set_target(200);

  nozzle.advance(300 * kSecond);

  CHECK(nozzle.celsius() == Approx(200).margin(0.5));
  CHECK(nozzle.power() == Approx(127 * 178.0 / 380).margin(3));
}

TEST_CASE("The bed is switched every five seconds and stays near its target") {
  Heater bed(bed_options());
  bed.set_target(60);
  bed.advance(200 * kSecond);

  for (int i = 0; i < 100; ++i) {
    bed.advance((200 + i) * kSecond);
    CHECK(bed.celsius() == Approx(60).margin(7));
  }
}

TEST_CASE("The way in steps does not change where it leads") {
  Heater once(nozzle_options());
  Heater often(nozzle_options());
  once.set_target(150);
  often.set_target(150);

  once.advance(30 * kSecond);
  for (int i = 1; i <= 3000; ++i) often.advance(Moment(10'000 * i));

  CHECK(often.celsius() == Approx(once.celsius()));
}

TEST_CASE("A target above the safe maximum is cut down to it") {
  Heater nozzle(nozzle_options());

  nozzle.set_target(999);

  CHECK(nozzle.target() == 260);
}

TEST_CASE("M109 reports each second, counts down once near, and answers after ten seconds there") {
  Dialogue host;

  const std::string heard = host.say("M109 S60", 200 * kSecond);

  CHECK(heard.starts_with(" T:22.00 /60.00 B:22.00 /0.00 @:0 B@:0 W:?\n T:"));
  CHECK(heard.find("W:?\necho:busy: processing\n T:") != std::string::npos);
  CHECK(heard.find(" W:9\n") != std::string::npos);
  CHECK(heard.ends_with("ok\n"));
  CHECK(host.printer().machine().nozzle.celsius() == Approx(60).margin(3));
}

TEST_CASE("M109 S does not wait to cool down, R does") {
  Dialogue host;
  host.say("M109 S60", 200 * kSecond);

  CHECK(host.say("M109 S40") == "ok\n");
  CHECK(host.say("M109 R50").find(" W:?\n") != std::string::npos);
}

TEST_CASE("M108 ends the wait for a heater") {
  Dialogue host;
  host.say("M109 S250", kSecond);

  CHECK(host.say("M108") == "ok\nok\n");
}
