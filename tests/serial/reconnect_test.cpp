// A cable that is pulled in a print, and put back.
#include "host/reconnect.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <mutex>

#include "host/serve/print_task.h"
#include "tests/serial/board.h"
#include "tests/support/child_process.h"
#include "tests/support/live_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;
using test::Board;
using test::MockedPort;

namespace {

/// A print of 300 beads on a mocked board, in which somebody pulls the cable.
class Print {
 public:
  using Deed = std::function<void(Board&)>;

  Print() {
    std::ofstream file(model_);
    for (const std::string& line : program_) file << line << '\n';
  }

  Result<std::string> run(const Deed& at_line_150, const Deed& when_gone) {
    bool pulled = false;
    PrintControl control({[&](const SenderEvent& event) {
                            const auto* message = std::get_if<MessageSeen>(&event);
                            if (message && message->text.find("is gone") != message->text.npos)
                              when_gone(board_);
                          },
                          [&](SenderState, const StreamFigures& figures) {
                            if (figures.counters.lines_sent != 150 || std::exchange(pulled, true))
                              return;
                            at_line_150(board_);
                          }});
    const auto ignore = [](auto...) {};
    const auto spec = job_spec_from_text("{}", {});
    REQUIRE(spec);
    const PrintTask task{model_, "a.gcode", true, *spec, MockedPort::kPath, journal_, {}};
    return run_print_task(task, control, {ignore, ignore, ignore});
  }

  /// The same by the command, in a process of its own.
  int run_command(const Deed& at_bead_100, const Deed& later) {
    ::setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 1);
    test::ChildProcess print(
        {"print", model_, "--port", MockedPort::kPath, "--journal", journal_, "--json"});
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (beads_after(std::chrono::milliseconds(1)).size() < 100)
      SLIPSTICK_CHECK(std::chrono::steady_clock::now() < until);
    at_bead_100(board_);
    (void)beads_after(std::chrono::milliseconds(300));
    later(board_);
    for (std::string line = print.line(); !line.empty(); line = print.line()) report_ += line;
    return print.wait();
  }
  const std::string& report() const { return report_; }

  std::vector<test::Bead> beads_after(std::chrono::milliseconds time) {
    std::this_thread::sleep_for(time);  // until the last moves are over
    const std::lock_guard lock(mutex_);
    return test::without_speed(beads_);
  }
  std::vector<test::Bead> whole() const { return test::quick_beads(program_); }

 private:
  test::TemporaryFolder folder_;
  std::string model_ = (folder_.path() / "a.gcode").string();
  std::string journal_ = (folder_.path() / "a.journal").string();
  std::vector<std::string> program_ = test::quick_program(300);
  std::string report_;
  std::mutex mutex_;  // protects the beads
  std::vector<test::Bead> beads_;
  MockedPort port_;
  Board board_{port_, Printer({}, [this, sink = test::into(beads_)](const ExecutedMove& move) {
                 const std::lock_guard lock(mutex_);
                 sink(move);
               })};
};

}  // namespace

TEST_CASE("A print whose cable is pulled goes on when it is back, on whatever port") {
  if (test::skipped()) return;
  Print print;

  const auto done =
      print.run([](Board& board) { board.unplug(); }, [](Board& board) { board.plug_in(1); });

  if (!done) FAIL(done.error().message);
  CHECK(print.beads_after(std::chrono::milliseconds(500)) == print.whole());
}

TEST_CASE("The print command tells how often the cable was put back") {
  if (test::skipped()) return;
  Print print;

  const int status = print.run_command([](Board& board) { board.unplug(); },
                                       [](Board& board) { board.plug_in(1); });

  CHECK(status == 0);
  CHECK_THAT(print.report(), Contains("\"reconnects\": 1"));
  CHECK(print.beads_after(std::chrono::milliseconds(500)) == print.whole());
}

TEST_CASE("A print whose board lost its power with the cable waits for consent") {
  if (test::skipped()) return;
  Print print;

  const auto done = print.run([](Board& board) { board.unplug_and_switch_off(); },
                              [](Board& board) { board.plug_in(1); });

  REQUIRE_FALSE(done);
  CHECK(done.error().code == ErrorCode::kInput);
  CHECK_THAT(done.error().message, Contains("start the print again"));
  CHECK(print.beads_after(std::chrono::milliseconds(500)).size() < print.whole().size());
}
