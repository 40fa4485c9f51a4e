#include <catch2/catch.hpp>
#include <string>

#include "core/base/rng.h"
#include "tests/sim/dialogue.h"

using namespace slipstick;

namespace {

const std::string kTemperatures = "T:22.00 /0.00 B:22.00 /0.00 @:0 B@:0\n";
const std::string kNumberError = "Error:Line Number is not Last Line Number+1, Last Line: ";

}  // namespace

TEST_CASE("Switched on, the board introduces itself after 70 ms") {
  Printer printer({});

  printer.advance(Moment(69'000));
  CHECK_FALSE(printer.output_at());

  printer.advance(Moment(71'000));
  std::array<char, 4096> buffer{};
  const std::string banner(buffer.data(), printer.take(buffer));
  CHECK(banner.starts_with("start\nPowerUp\nMarlin 2.1.2\necho: Last Updated: 2022-12-17 | "));
  CHECK(banner.find("echo:  M205 B20000.00 S0.00 T0.00 J0.01\n") != std::string::npos);
  CHECK(banner.ends_with("echo:; Hotend PID:\necho:  M301 P22.20 I1.08 D114.00\n"));
}

TEST_CASE("Replies to single lines are those of Marlin 2.1.2") {
  struct Exchange {
    const char* said;
    std::string heard;
  };
  const Exchange exchanges[] = {
      {"M105", "ok " + kTemperatures},
      {" M105", "ok " + kTemperatures},
      {"M105;x", "ok " + kTemperatures},
      {"M105*121", "ok " + kTemperatures},
      {"M105*1", "ok " + kTemperatures},
      {"", ""},
      {"; only comment", ""},
      {"M114", "X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\nok\n"},
      {"G92 E0", "X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\nok\n"},
      {"M78", "echo:Unknown command: \"M78\"\nok\n"},
      {"M73 P10 R5", "echo:Unknown command: \"M73 P10 R5\"\nok\n"},
      {"X5 M105*36", "echo:Unknown command: \"X5 M105\"\nok\n"},
      {"m115", "echo:Unknown command: \"m115\"\nok\n"},
      {"(paren) M105", "echo:Unknown command: \"(paren) M105\"\nok\n"},
      {"\xff\xfe\xfd M105", "echo:Unknown command: \"\xff\xfe\xfd M105\"\nok\n"},
      {"M117 hello", "ok\n"},
      {"M118 E1 hello", "echo:hello\r\nok\n"},
      {"M118 A1 hello", "//hello\r\nok\n"},
      {"M118 hello", "hello\r\nok\n"},
      {"M113", "echo:M113 S2\nok\n"},
      {"M220", "FR:100%\nok\n"},
      {"M221", "echo:E0 Flow: 100%\nok\n"},
      {"M201", "  M201 X3000.00 Y3000.00 Z100.00 E10000.00\nok\n"},
      {"M203", "  M203 X300.00 Y300.00 Z5.00 E25.00\nok\n"},
      {"M204", "  M204 P3000.00 R3000.00 T3000.00\nok\n"},
      {"M205", "  M205 B20000.00 S0.00 T0.00 J0.01\nok\n"},
      {"M92", "  M92 X80.00 Y80.00 Z400.00 E500.00\nok\n"},
      {"M302", "echo:Cold extrudes are disabled (min temp 170C)\nok\n"},
      {"M119", "Reporting endstop status\nx_min: open\ny_min: open\nz_min: open\nok\n"},
      {"T0", "ok\n"},
      {"T1", "echo:T1 Invalid extruder\nok\n"},
      {"M108", "ok\n"},
      {"G1 E5 F300", "echo: cold extrusion prevented\nok\n"},
      {"M106 S128", "ok\n"},
      {"M400", "ok\n"},
      {"G4 P50", "ok\n"},
      {"G1 X", "ok\n"},
      {"M110 N100", "ok\n"},
      {"N101 M105*39", "ok " + kTemperatures},
  };
  Dialogue host;

  for (const Exchange& exchange : exchanges) {
    INFO(exchange.said);
    CHECK(host.say(exchange.said) == exchange.heard);
  }
}

TEST_CASE("A NUL ends a line for whoever reads it as a string") {
  Dialogue host;

  CHECK(host.send(std::string_view("\0\xff\x80\n", 4)) == "echo:Unknown command: \"\"\nok\n");
}

TEST_CASE("Bad numbered lines get Error, Resend and ok; duplicates get nothing") {
  struct Exchange {
    const char* said;
    std::string heard;
  };
  const std::string good = "ok " + kTemperatures;
  const Exchange exchanges[] = {
      {"N0 M110 N0*125", "ok\n"},
      {"N1 M105*38", good},
      {"N2 M105*99", "Error:checksum mismatch, Last Line: 1\nResend: 2\nok\n"},
      {"N2 M105*37", good},
      {"N3 M105", "Error:No Checksum with line number, Last Line: 2\nResend: 3\nok\n"},
      {"N3 M105*36", good},
      {"N7 M105*32", kNumberError + "3\nResend: 4\nok\n"},
      {"N4 M105*35", good},
      {"N4 M105*35", ""},
      {"N3 M105*36", ""},
      {"N2 M105*37", kNumberError + "4\nResend: 5\nok\n"},
      {"N5555 M105*23", kNumberError + "4\nResend: 5\nok\n"},
      {"N5 M105*34", good},
      {"N6 M105*33N7 M105*32", "Error:checksum mismatch, Last Line: 5\nResend: 6\nok\n"},
      {"N6 M105*33", good},
      {"N7 M105*32", good},
      {"N8 M105*47  ", good},
      {"N9 M105*46\r", good},
      {"  N10 M105*22", good},
      {"N11 M105 ;foo*105", "Error:No Checksum with line number, Last Line: 10\nResend: 11\nok\n"},
      {"N11 M105*23 ;foo", good},
      {"N200 M110*33", "ok\n"},
      {"N201 M105*36", good},
      {"N-1 M110*15", "ok\n"},
      {"N0 M105*39", good},
  };
  Dialogue host;

  for (const Exchange& exchange : exchanges) {
    INFO(exchange.said);
    CHECK(host.say(exchange.said) == exchange.heard);
  }
}

TEST_CASE("Of a line over 95 bytes the head is kept and the checksum lost") {
  Dialogue host;

  CHECK(host.say("N1 M117 " + std::string(192, 'x') + "*1") ==
        "Error:No Checksum with line number, Last Line: 0\nResend: 1\nok\n");
}

TEST_CASE("An M110 without a number prefix acts when its turn comes") {
  Dialogue host;

  CHECK(host.send("M110 N41\nN42 M105*22\n").starts_with(kNumberError + "0\nResend: 1\nok\n"));
}

TEST_CASE("Commands queued before a bad line keep their oks, which come after the Resend") {
  Dialogue host;

  const std::string heard = host.send("G90\nM82\nN5 G1 X1*0\n");

  CHECK(heard == kNumberError + "0\nResend: 1\nok\nok\nok\n");
}

TEST_CASE("What lies in the receive buffer behind a bad line is flushed") {
  Dialogue host;

  CHECK(host.send("N5 G1 X1*0\nM114\nM114\n") == kNumberError + "0\nResend: 1\nok\n");
}

TEST_CASE(
    "What arrives while Resend is printed is not flushed: the tail of a line becomes a command") {
  Dialogue host({.baud = 115200});
  std::string lines = "N1 G1 X1*0\n";
  for (int n = 2; n <= 10; ++n) lines += "N" + std::to_string(n) + " G1 X12 F3000*5\n";

  const std::string heard = host.send(lines);

  CHECK(heard.starts_with("Error:checksum mismatch, Last Line: 0\nResend: 1\nok\n"));
  CHECK(heard.find("echo:Unknown command: \"") != std::string::npos);
  CHECK(host.printer().statistics().resends_requested > 1);
}

TEST_CASE("An overfed UART loses bytes without a word") {
  Dialogue host({.baud = 115200});
  host.say("G4 P500", Moment(10'000));

  for (int i = 0; i < 30; ++i) host.send("M117 abcdefghijklmnopqrstuvwxyz\n", Moment(1'000));

  CHECK(host.printer().statistics().bytes_overrun > 0);
}

TEST_CASE("Over USB nothing is lost: the board lets the host wait") {
  Dialogue host;
  host.say("G4 P500", Moment(10'000));

  std::string heard;
  for (int i = 0; i < 30; ++i)
    heard += host.send("M117 abcdefghijklmnopqrstuvwxyz\n", Moment(1'000));
  heard += host.listen(kSecond);

  std::string oks;
  for (int i = 0; i < 31; ++i) oks += "ok\n";
  CHECK(heard == oks);
  CHECK(host.printer().statistics().bytes_overrun == 0);
}

TEST_CASE("A long command is busy every two seconds") {
  Dialogue host;

  CHECK(host.say("G4 S5", 6 * kSecond) == "echo:busy: processing\necho:busy: processing\nok\n");
}

TEST_CASE("Homing two axes leaves the third where it is, and renamed as it was") {
  Dialogue host;
  host.say("G92 Z30");
  host.say("G1 X5 Y5 Z35 F6000", 10 * kSecond);

  const std::string report = host.say("G28 X Y", 16 * kSecond);

  CHECK_THAT(report, Catch::Contains("X:0.00 Y:0.00 Z:35.00"));
  CHECK(host.printer().machine().planner.target().z == 5);
}

TEST_CASE("Homing takes its time, reports the position and makes the soft endstops act") {
  Dialogue host;
  std::string busy;
  for (int i = 0; i < 7; ++i) busy += "echo:busy: processing\n";

  CHECK(host.say("G28", 16 * kSecond) ==
        busy + "X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0\nok\n");
  host.say("G1 X999 Y-5 F18000");
  CHECK(host.say("M114").starts_with("X:220.00 Y:0.00 Z:0.00"));
}

TEST_CASE("Fifteen moves are acknowledged at once, then one each time a move ends") {
  Dialogue host;
  std::string lines;
  for (int i = 1; i <= 10; ++i) lines += "G1 X10 F600\nG1 X0 F600\n";

  // 10 mm at 10 mm/s take a second, and 1/300 s more for the two ramps at 3000 mm/s².
  const std::string at_once = host.send(lines, Moment(500'000));
  const std::string later = host.listen(kSecond);

  CHECK(at_once.size() == 15 * 3);
  CHECK(later == "ok\n");
}

TEST_CASE("M112 at the start of a line kills at once, even while another command runs") {
  Dialogue host;
  host.say("M104 S200");
  host.say("G4 S60");

  CHECK(host.say("M112") == "echo:M112 Shutdown\nError:Printer halted. kill() called!\n");
  CHECK(host.say("M105", 5 * kSecond).empty());
  CHECK(host.printer().machine().nozzle.off());
}

TEST_CASE("After a reset the board starts anew and counts lines from 1") {
  Dialogue host;
  host.say("N1 M140 S60*98");
  host.say("M112");

  host.printer().reset();

  CHECK(host.listen(kSecond).starts_with("start\n"));
  CHECK(host.say("N1 M105*38") == "ok " + kTemperatures);
}

TEST_CASE("M155 reports by itself, with a blank where the ok was") {
  Dialogue host;

  CHECK(host.say("M155 S1", Moment(2'500'000)) == "ok\n " + kTemperatures + " " + kTemperatures);
  CHECK(host.say("M155 S0", 3 * kSecond) == "ok\n");
}

TEST_CASE("G90 and G91 speak for E too, the last of G90, G91, M82 and M83 counts") {
  Dialogue host;
  host.say("M302 S0");
  host.say("M83");
  host.say("G1 E1 F300");
  host.say("G1 E1");
  CHECK(host.say("M114").find(" E:2.00 ") != std::string::npos);

  host.say("G90");
  host.say("G1 E5");

  CHECK(host.say("M114").find(" E:5.00 ") != std::string::npos);
}

TEST_CASE("What is sent while the board boots is lost") {
  Printer printer({});
  printer.receive(std::string(60, 'x') + "\n" + std::string(90, 'y') + "\nM117\n", Moment(0));

  printer.advance(kSecond);

  std::array<char, 4096> buffer{};
  const std::string heard(buffer.data(), printer.take(buffer));
  CHECK(heard.ends_with("D114.00\n"));
  CHECK(printer.unread() == 0);
}

TEST_CASE("Any bytes may come: the board answers and lives") {
  Rng rng(11);
  Dialogue host;
  for (int round = 0; round < 3'000; ++round) {
    std::string line = rng.below(2) != 0 ? "G1 X" : "M20";
    for (std::uint64_t i = rng.below(60); i > 0; --i) {
      line += "GMTNXYZEFSRPJB0123456789.-* ;\n"[rng.below(30)];
    }
    host.say(line, Moment(1'000));
    host.printer().reset();
    host.listen(kSecond);
  }

  CHECK(host.say("M117") == "ok\n");
}

TEST_CASE("The same seed gives the same bytes, another seed others") {
  const auto run = [](std::uint64_t seed) {
    Dialogue host({.baud = 250000, .corrupt = 0.02, .seed = seed});
    std::string heard;
    for (int i = 0; i < 50; ++i) heard += host.say("M114");
    return heard;
  };

  CHECK(run(7) == run(7));
  CHECK(run(7) != run(8));
}
