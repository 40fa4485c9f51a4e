// Commands that wait for somebody, and what ends the wait.
#include <catch2/catch.hpp>
#include <vector>

#include "sim/emergency_parser.h"
#include "sim/sim_options.h"
#include "tests/sim/dialogue.h"

using namespace slipstick;
using Catch::Contains;

namespace {

using Kind = Emergency::Kind;

std::vector<Emergency> found_in(std::string_view bytes) {
  EmergencyParser parser;
  std::vector<Emergency> found;
  for (const char byte : bytes) {
    if (const auto emergency = parser.feed(byte)) found.push_back(*emergency);
  }
  return found;
}

Dialogue with(const std::string& features, const Planner::Sink& sink = {}) {
  return Dialogue(sim_options({{"with", features}})->printer, sink);
}

std::size_t count(const std::string& text, std::string_view what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// Homed, hot, at (50, 60, 5) with 3 mm of filament pushed.
void get_ready(Dialogue& dialogue) {
  dialogue.say("G28", 20 * kSecond);
  dialogue.say("M109 S200", 300 * kSecond);
  dialogue.say("M83");
  dialogue.say("G1 X50 Y60 Z5 E3 F3000", 5 * kSecond);
}

}  // namespace

TEST_CASE("The emergency parser obeys a code at the start of a line, whatever follows it") {
  CHECK(found_in("M112\n") == std::vector{Emergency{Kind::kKill}});
  CHECK(found_in("M1120\n") == std::vector{Emergency{Kind::kKill}});
  CHECK(found_in("M112 now\r\n") == std::vector{Emergency{Kind::kKill}});
  CHECK(found_in("  N12 M112*33\n") == std::vector{Emergency{Kind::kKill}});
  CHECK(found_in("N-1M108\n") == std::vector{Emergency{Kind::kContinue}});
  CHECK(found_in("M410\nM876 S3\n") ==
        std::vector{Emergency{Kind::kQuickStop}, Emergency{Kind::kAnswer, 3}});
}

TEST_CASE("The emergency parser lets everything else pass") {
  CHECK(found_in("M112").empty());  // the line has not ended
  for (const char* line : {"G1 X5 M112\n", "XM112\n", "M 1 12\n", "M118 M112\n", "M117 M108\n",
                           "M876\n", "M876 Sx\n", "m112\n", "M11\n", "NM\n", "\n"}) {
    INFO(line);
    CHECK(found_in(line).empty());
  }
}

TEST_CASE("With an emergency parser M112 acts behind a number and in front of a full queue") {
  const std::string flood = "G4 S60\nG4\nG4\nG4\nG4\nG4\nG4\nN9 M112*0\n";

  Dialogue plain;
  plain.send(flood, kSecond);
  CHECK_FALSE(plain.printer().machine().halted);

  Dialogue parsed = with("emergency-parser");
  CHECK_THAT(parsed.send(flood, kSecond), Contains("echo:M112 Shutdown\nError:Printer halted"));
  CHECK(parsed.printer().machine().halted);
}

TEST_CASE("With an emergency parser M108 ends a heat-up though the queue is full") {
  Dialogue dialogue = with("emergency-parser");
  CHECK(count(dialogue.send("M109 S200\nG4\nG4\nG4\nG4\n", 5 * kSecond), "ok") == 0);

  CHECK(count(dialogue.say("M108", kSecond), "ok") == 6);
}

TEST_CASE("What a firmware is built with shows in its capabilities") {
  CHECK_THAT(Dialogue().say("M115", kSecond), Contains("Cap:EMERGENCY_PARSER:0") &&
                                                  Contains("Cap:RUNOUT:0") &&
                                                  Contains("Cap:PROMPT_SUPPORT:0"));
  CHECK_THAT(with("emergency-parser,filament-sensor,host-prompts").say("M115", kSecond),
             Contains("Cap:EMERGENCY_PARSER:1") && Contains("Cap:RUNOUT:1") &&
                 Contains("Cap:PROMPT_SUPPORT:1") && Contains("Cap:HOST_ACTION_COMMANDS:1"));
}

TEST_CASE("M0 waits for M108 and says so, for seconds where it is told how many") {
  CHECK_THAT(Dialogue().say("M0"), Contains("Unknown command"));

  Dialogue dialogue = with("filament-change");
  const std::string waiting = dialogue.say("M0 Turn the plate", 5 * kSecond);
  CHECK_THAT(waiting, Contains("echo:Turn the plate\n"));
  CHECK(count(waiting, "echo:busy: paused for user\n") == 2);
  CHECK(count(waiting, "ok") == 0);
  CHECK(count(dialogue.say("M108", kSecond), "ok\n") == 2);

  CHECK(dialogue.say("M1 S3", Moment(2'900'000)) == "echo:busy: paused for user\n");
  CHECK(dialogue.listen(kSecond) == "ok\n");
}

TEST_CASE("M0 shows a prompt, and M876 answers it past the queue") {
  Dialogue dialogue = with("filament-change,host-prompts,emergency-parser");

  CHECK_THAT(dialogue.say("M0", kSecond),
             Contains("//action:prompt_end\n//action:prompt_begin M0 Stop\n"
                      "//action:prompt_button Continue\n//action:prompt_show\n"));
  CHECK(count(dialogue.say("M876 S0", kSecond), "ok\n") == 2);
}

TEST_CASE("M600 parks, waits, and comes back to where it was") {
  std::vector<ExecutedMove> made;
  Dialogue dialogue =
      with("filament-change,host-prompts", [&](const ExecutedMove& move) { made.push_back(move); });
  get_ready(dialogue);
  made.clear();

  const std::string parked = dialogue.say("M600", 20 * kSecond);
  CHECK_THAT(parked, Contains("//action:paused\n") && Contains("prompt_begin Nozzle Parked\n") &&
                         Contains("echo:Insert filament and send M108\n"));
  CHECK(made.back().to == Axes{10, 210, 25, 1});
  const std::string resumed = dialogue.say("M108", 20 * kSecond);
  CHECK(count(resumed, "ok\n") == 2);
  CHECK_THAT(resumed, Contains("//action:resumed\nok\n"));
  CHECK(made.back().to == Axes{50, 60, 5, 3});
  CHECK_THAT(dialogue.say("M114"), Contains("X:50.00 Y:60.00 Z:5.00 E:3.00"));
}

TEST_CASE("M600 lets the nozzle go cold when nobody comes, and heats it before it goes on") {
  Dialogue dialogue = with("filament-change");
  get_ready(dialogue);
  dialogue.say("M600", 20 * kSecond);

  CHECK_THAT(dialogue.listen(60 * kSecond), Contains("echo:Send M108 to heat nozzle\n"));
  CHECK(dialogue.printer().machine().nozzle.off());
  dialogue.listen(600 * kSecond);

  dialogue.say("M108", 20 * kSecond);
  CHECK(dialogue.printer().machine().nozzle.target() == 200);
  std::string heating;
  for (int i = 0; i < 30 && count(heating, "Insert filament") == 0; ++i) {
    heating += dialogue.listen(5 * kSecond);
  }
  CHECK_THAT(heating, Contains(" W:0\n") && Contains("echo:Insert filament and send M108\n"));
  CHECK(count(dialogue.say("M108", 20 * kSecond), "ok\n") == 3);  // of M600 and of M108, twice
}

TEST_CASE("Where filament runs out the firmware changes it, between two commands") {
  Dialogue dialogue = with("filament-change,filament-sensor,host-prompts");
  get_ready(dialogue);
  CHECK(dialogue.say("M412") == "echo:Filament runout ON ; Host handling OFF\nok\n");

  CHECK(dialogue.say("G1 X60 E1 F3000") == "ok\n");
  dialogue.printer().run_out_of_filament();
  const std::string ran_out = dialogue.say("G1 X70 E1", 20 * kSecond);
  CHECK_THAT(ran_out,
             Contains("//action:filament_runout T0\n//action:paused filament_runout 0\n") &&
                 Contains("echo:Insert filament and send M108\n"));
  CHECK(count(ran_out, "ok\n") == 0);
  const std::string went_on = dialogue.say("M108", 20 * kSecond);
  CHECK_THAT(went_on, Contains("//action:resumed\n"));
  CHECK(count(went_on, "ok\n") == 2);  // of G1 and M108; nobody sent M600
  CHECK_FALSE(dialogue.printer().machine().spool->empty);
  CHECK(count(dialogue.say("M105"), "ok") == 1);
}

TEST_CASE("Where the host is to handle it, or nobody looks, the firmware goes on") {
  Dialogue host = with("filament-change,filament-sensor,host-prompts");
  get_ready(host);
  host.say("M412 H1");
  host.printer().run_out_of_filament();
  const std::string asked = host.say("G1 X60 E1 F3000", 20 * kSecond);
  CHECK_THAT(asked, Contains("//action:pause filament_runout 0\n"));
  CHECK_THAT(asked, !Contains("Insert filament"));

  Dialogue blind = with("filament-change,filament-sensor,host-prompts");
  get_ready(blind);
  blind.say("M412 S0");
  blind.printer().run_out_of_filament();
  CHECK(blind.say("G1 X60 E1 F3000", 20 * kSecond) == "ok\n");
}
