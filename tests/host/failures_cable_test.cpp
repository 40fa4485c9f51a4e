// A whole print over each kind of bad cable, bad port and bad neighbour, in virtual time.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/host/recorded_print.h"

using namespace slipstick;
using Catch::Contains;
using namespace std::chrono_literals;

namespace {

constexpr int kMoves = 300;

const std::vector<std::string>& program() {
  static const std::vector<std::string> lines = test::cold_program(kMoves);
  return lines;
}

void check_whole(const std::map<std::string, std::string>& printer) {
  static const std::vector<Vec3> whole = test::print_recorded(program(), {}).places;
  const auto print = test::print_recorded(program(), printer);
  const auto fault = printer.find("fault");
  INFO((fault == printer.end() ? "" : fault->second) << ": " << print.message());
  CHECK(print.outcome);
  CHECK((print.faults > 0 || fault == printer.end()));
  CHECK(print.places.size() == kMoves);
  CHECK(print.places == whole);
}

}  // namespace

TEST_CASE("Bytes that the host's machine loses at 250000 baud lose no line") {
  check_whole({{"baud", "250000"}, {"seed", "2"}, {"fault", "lose-tx=0.003"}});
}

TEST_CASE("One byte in a hundred lost on the way to the board is still a print") {
  check_whole({{"baud", "250000"}, {"seed", "4"}, {"fault", "lose-rx=0.01"}});
}

TEST_CASE("Acknowledgements that come twice skip no line") {
  check_whole({{"fault", "double-ok=0.3"}});
  check_whole({{"fault", "double-line-tx=0.3"}});
}

TEST_CASE("Words of other programs on the port are answered and harm nothing") {
  for (const char* when : {"@0.5", "@1", "@line3", "@line50"}) {
    for (const char* words :
         {"AT", "ATZ", "XYZv3/query=a", "echo", "M105", "T:20 /0", "AT+CGMI;+CGMM"}) {
      check_whole({{"fault", std::string("hear=") + words + when}});
    }
  }
}

TEST_CASE("Acknowledgements that nobody has asked for skip no line") {
  for (const char* words :
       {"ok", "ok N4 P15 B3", "ok T:20.0 /0.0", "wait", "Resend: 2", "skip 4"}) {
    check_whole({{"fault", std::string("say=") + words + "@line3,say=" + words + "@line50"}});
  }
}

TEST_CASE("A board that is deaf while it starts is greeted until it hears") {
  check_whole({{"fault", "deaf@0.1-1"}});
  check_whole({{"fault", "deaf@0.1-8"}});
  check_whole({{"fault", "mute@0.1-8"}});
}

TEST_CASE("A board that takes nothing for a minute holds the print up, no more") {
  check_whole({{"fault", "deaf=60@line50"}});
  check_whole({{"fault", "freeze=60@line50"}});
  check_whole({{"fault", "late=3@line50"}});
}

TEST_CASE("A firmware that stands still is given up within ten minutes, and said to be maybe hot") {
  const auto print = test::print_recorded(program(), {{"fault", "freeze@line50"}});

  CHECK_THAT(print.message(), Contains("has not answered") && Contains("may still be on"));
  CHECK(print.ended < 10min);
}

TEST_CASE("A cable that is pulled ends the print with a reason, wherever it is") {
  for (const char* when : {"@0.01", "@1", "@2.6", "@line2", "@line50", "@line299"}) {
    INFO(when);
    const auto print = test::print_recorded(program(), {{"fault", std::string("unplug") + when}});
    CHECK_THAT(print.message(), Contains("the cable is out"));
  }
}

TEST_CASE("A supply that sags when the heaters are up ends the print, and nothing moves after") {
  std::vector<std::string> hot{"M140 S50", "M109 S200"};
  hot.insert(hot.end(), program().begin(), program().end());
  for (const char* fault : {"brown-out@line6", "unplug@line6", "silent-reset@line6"}) {
    INFO(fault);
    const auto print = test::print_recorded(hot, {{"fault", fault}});
    CHECK(!print.outcome);
    CHECK(print.places.size() < 10);
  }
}

TEST_CASE("Killed or reset at any line, a board gets no further line of the job") {
  for (const char* fault : {"kill", "reset", "watchdog", "silent-reset"}) {
    for (int line = 4; line < 300; line += 37) {
      INFO(fault << " at line " << line);
      const auto print = test::print_recorded(
          program(), {{"fault", std::string(fault) + "@line" + std::to_string(line)}});
      CHECK(!print.outcome);
      CHECK(static_cast<int>(print.places.size()) <= line);
    }
  }
}

TEST_CASE("Every firmware that counts lines prints the same over a bad cable") {
  for (const char* firmware :
       {"marlin-1.0.2", "marlin-1.1.9", "marlin-2.0.7", "marlin-2.0.8", "marlin-2.0.9",
        "marlin-2.1.2", "creality", "prusa-mk3", "smoothieware"}) {
    INFO(firmware);
    check_whole({{"firmware", firmware}});
    check_whole({{"firmware", firmware}, {"fault", "lose-rx=0.003,lose-ok=0.01"}, {"seed", "9"}});
  }
}

TEST_CASE("A firmware that does not count lines is refused before anything moves") {
  const auto* firmware = GENERATE("reprapfirmware", "klipper");
  const auto print = test::print_recorded(program(), {{"firmware", firmware}});

  CHECK_THAT(print.message(), Contains("does not count lines"));
  CHECK(print.places.empty());
}

TEST_CASE("A firmware that does not answer M105 as Marlin does is refused before anything moves") {
  const auto print = test::print_recorded(program(), {{"firmware", "repetier"}});

  CHECK_THAT(print.message(), Contains("no Marlin answers"));
  CHECK(print.places.empty());
}

TEST_CASE("A program that resets the board's errors by M999 loses no line") {
  auto lines = program();
  for (std::size_t at = 10; at < lines.size(); at += 50) {
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), "M999");
  }
  const auto print = test::print_recorded(lines, {});

  INFO(print.message());
  CHECK(print.outcome);
  CHECK(print.places == test::print_recorded(program(), {}).places);
}

TEST_CASE("Lines reach the port whole: no board ever waits for the rest of one") {
  const auto print = test::print_recorded(program(), {{"fault", "flip-rx=0.002,lose-ok=0.02"}});

  REQUIRE(print.outcome);
  REQUIRE(print.writes.size() > program().size());
  for (const auto& write : print.writes) CHECK(write.bytes.ends_with('\n'));
}
