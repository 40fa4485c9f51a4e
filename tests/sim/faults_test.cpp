// Faults by name: what each does to a dialogue, and which names, values and times there are.
#include <catch2/catch.hpp>
#include <string>

#include "sim/faults/fault_names.h"
#include "tests/sim/dialogue.h"

using namespace slipstick;
using Catch::Contains;

namespace {

Dialogue with(const char* fault, int baud = 0) {
  PrinterOptions options;
  options.baud = baud;
  options.faults = {FaultSpec::parse(fault).value()};
  return Dialogue(options);
}

std::string refused(const char* fault) {
  const auto spec = FaultSpec::parse(fault);
  return spec ? "" : spec.error().message;
}

const std::string kReport = "X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\nok\n";

}  // namespace

TEST_CASE("A name, a value or a time that cannot be is refused with what can") {
  CHECK_THAT(refused("flop"), Contains("flip-rx") && Contains("runout"));
  CHECK_THAT(refused("flip-rx=2"), Contains("a share, 0 to 1"));
  CHECK_THAT(refused("mute=-1"), Contains("give seconds"));
  CHECK_THAT(refused("reset=3"), Contains("has no value"));
  CHECK_THAT(refused("say"), Contains("give words"));
  for (const char* when : {"reset@", "reset@soon", "reset@5-4", "reset@-3", "reset@line",
                           "reset@line1.5", "reset@2000000"}) {
    CHECK_THAT(refused(when), Contains("SECONDS, FROM-TO or lineN"));
  }
  CHECK(refused("") != "");
  CHECK(refused("lose-ok=0.5@10-20").empty());
}

TEST_CASE("Each fault there is can be told without a value, words apart, and is in the help") {
  for (const FaultName& name : fault_names()) {
    INFO(name.name);
    CHECK(FaultSpec::parse(name.name).has_value() == (name.value != FaultValue::kWords));
    CHECK_THAT(help_on_faults(), Contains(std::string(name.name)));
  }
}

TEST_CASE("Bytes and lines to the board are lost, doubled and flipped") {
  CHECK(with("lose-rx=1").say("M114").empty());
  CHECK(with("double-rx=1").say("M114") == "echo:Unknown command: \"MM111144\"\nok\n");
  CHECK_THAT(with("flip-rx=1").send("M114\nM114\nM114\n"), !Contains("Count"));
  CHECK(with("lose-line-rx=1").say("M114").empty());
  CHECK(with("double-line-rx=1").say("M114") == kReport + kReport);
  CHECK_THAT(with("garble-line-rx=1").say("M114"), !Contains("Count"));
}

TEST_CASE("A line that the host has begun is damaged when it is whole, or let through at the end") {
  Dialogue host = with("double-line-rx=1@0-2");
  CHECK(host.send("M1").empty());
  CHECK(host.send("14\n") == kReport + kReport);
  CHECK(host.send("M1", 2 * kSecond).empty());
  CHECK(host.send("14\n") == kReport);
}

TEST_CASE("Bytes and lines to the host are lost, doubled, flipped and glued") {
  CHECK(with("lose-tx=1").say("M114").empty());
  CHECK(with("double-tx=1").say("M117") == "ookk\n\n");
  CHECK_THAT(with("flip-tx=1").say("M117"), !Contains("ok"));
  CHECK(with("lose-line-tx=1").say("M114").empty());
  CHECK(with("double-line-tx=1").say("M117") == "ok\nok\n");
  CHECK_THAT(with("garble-line-tx=1").say("M117"), !Contains("ok"));
  CHECK(with("glue-tx=1").say("M117") == "ok");
}

TEST_CASE("Only acknowledgements are lost, doubled and garbled") {
  CHECK(with("lose-ok=1").say("M113") == "echo:M113 S2\n");
  CHECK(with("double-ok=1").say("M113") == "echo:M113 S2\nok\nok\n");
  CHECK_THAT(with("garble-ok=1").say("M113"), Contains("echo:M113 S2\n") && !Contains("ok\n"));
}

TEST_CASE("Only requests are lost, doubled and given a wrong number") {
  const std::string error = "Error:No Checksum with line number, Last Line: 0\n";

  CHECK(with("lose-resend=1").say("N1 M114") == error + "ok\n");
  CHECK(with("double-resend=1").say("N1 M114") == error + "Resend: 1\nResend: 1\nok\n");
  const std::string wrong = with("wrong-resend=1").say("N1 M114");
  CHECK_THAT(wrong, Contains("Resend: ") && !Contains("Resend: 1\n"));
}

TEST_CASE("What the board says late holds up neither the board nor its words") {
  Dialogue host = with("late=2@2");
  host.listen(kSecond);
  CHECK(host.say("M104 S60").empty());
  CHECK(host.printer().machine().nozzle.target() == 60);
  CHECK(host.listen(2 * kSecond) == "ok\n");
}

TEST_CASE("For a spell the board is mute, deaf or stands still") {
  Dialogue mute = with("mute=2@2");
  mute.listen(kSecond + Moment(1));
  CHECK(mute.say("G90").empty());
  CHECK(mute.listen(2 * kSecond).empty());
  CHECK(mute.say("G90") == "ok\n");

  Dialogue deaf = with("deaf=2@2");
  deaf.listen(kSecond + Moment(1));
  CHECK(deaf.say("G90", 3 * kSecond).empty());
  CHECK(deaf.say("G90") == "ok\n");

  Dialogue frozen = with("freeze=2@2");
  frozen.listen(kSecond + Moment(1));
  CHECK(frozen.say("G90").empty());
  CHECK(frozen.listen(2 * kSecond) == "ok\n");
}

TEST_CASE("While the firmware stands, heaters keep their power, also beyond their target") {
  Dialogue host = with("freeze=60@10");
  host.say("M104 S200", 9 * kSecond);

  host.listen(50 * kSecond);

  CHECK(host.printer().machine().nozzle.true_celsius() > 195);
  CHECK(host.listen(20 * kSecond).empty());
  CHECK(host.printer().machine().nozzle.power() == 0);
}

TEST_CASE("A pulled cable loses what is under way; the board goes on") {
  Dialogue host = with("unplug=3@2");
  host.listen(kSecond);
  CHECK_FALSE(host.printer().plugged());
  CHECK(host.say("M104 S200", 3 * kSecond).empty());
  CHECK(host.printer().plugged());
  CHECK(host.printer().machine().nozzle.off());
  CHECK(host.say("M117") == "ok\n");
}

TEST_CASE("Each reset tells its cause, or nothing; the line numbers begin anew") {
  const std::pair<const char*, const char*> resets[] = {
      {"reset@2", "start\n External Reset\nMarlin"},
      {"brown-out@2", "start\n Brown out Reset\nMarlin"},
      {"watchdog@2", "start\n Watchdog Reset\nMarlin"},
      {"silent-reset@2", ""}};
  for (const auto& [fault, text] : resets) {
    INFO(fault);
    Dialogue host = with(fault);
    REQUIRE(host.say("N1 M104 S200*102") == "ok\n");
    const std::string banner = host.listen(2 * kSecond);
    CHECK(banner.substr(0, std::string(text).size()) == text);
    CHECK(banner.empty() == std::string(text).empty());
    CHECK(host.printer().machine().nozzle.off());
    CHECK(host.say("N1 M117*37") == "ok\n");
  }
}

TEST_CASE("A fault begins when the board has taken so many lines") {
  Dialogue host = with("kill@line3");
  CHECK(host.say("G90") == "ok\n");
  CHECK(host.say("G90") == "ok\n");
  CHECK_THAT(host.say("G90"), Contains("Error:Printer halted. kill() called!\n"));
  CHECK(host.say("G90").empty());
}

TEST_CASE("Without a time a fault comes at a moment from the seed, the same for the same seed") {
  const auto killed_at = [](std::uint64_t seed) {
    PrinterOptions options;
    options.seed = seed;
    options.faults = {FaultSpec::parse("kill").value()};
    Printer printer(options);
    while (!printer.machine().halted) printer.advance(printer.now() + Moment(10'000));
    return printer.now();
  };

  CHECK(killed_at(1) == killed_at(1));
  CHECK(killed_at(1) != killed_at(2));
  CHECK(killed_at(3) > FaultName::kEarliest);
  CHECK(killed_at(3) <= FaultName::kLatest + Moment(10'000));
}

TEST_CASE("Words come from the board that are no answer, and reach it from elsewhere") {
  Dialogue speaks = with("say=//action:pause@2");
  CHECK(speaks.listen(2 * kSecond) == "//action:pause\n");

  Dialogue hears = with("hear=AT@2");
  CHECK(hears.listen(2 * kSecond) == "echo:Unknown command: \"AT\"\nok\n");
}

TEST_CASE("Without plastic moves are made and nothing is laid") {
  PrinterOptions options;
  options.faults = {FaultSpec::parse("runout@line3").value()};
  double laid = 0;
  Dialogue host(options, [&laid](const ExecutedMove& move) { laid += move.filament(); });
  host.say("M302 S0");
  host.say("G1 X10 E1 F6000", kSecond);
  host.say("G1 X20 E2 F6000", kSecond);

  CHECK(laid == Approx(1));
  CHECK(host.printer().statistics().motion.filament_mm == Approx(2));
}

TEST_CASE("The same faults and seed give the same bytes, over a paced wire as well") {
  const auto run = [](std::uint64_t seed) {
    PrinterOptions options;
    options.baud = 115200;
    options.seed = seed;
    for (const char* fault : {"flip-tx=0.01", "lose-ok=0.1", "double-line-rx=0.1"}) {
      options.faults.push_back(FaultSpec::parse(fault).value());
    }
    Dialogue host(options);
    std::string heard;
    for (int i = 0; i < 50; ++i) heard += host.say("M114");
    return heard;
  };

  CHECK(run(7) == run(7));
  CHECK(run(7) != run(8));
}
