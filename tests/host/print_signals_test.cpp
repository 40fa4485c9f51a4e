// What a print does on signals, seen by the printer at the other end of a socket.
#include <signal.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <optional>
#include <thread>

#include "tests/support/child_process.h"
#include "tests/support/obedient_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using namespace std::chrono_literals;

namespace {

class SignalledPrint {
 public:
  SignalledPrint() {
    const auto path = folder_.path() / "moves.gcode";
    std::ofstream file(path);
    file << "M104 S200\nM83\nG1 X1 Y2 Z3\n";
    for (int i = 0; i < kMoves; ++i) file << "G1 X" << 50 + i % 9 << " E1\n";
    file.close();
    print_.emplace(std::vector<std::string>{"print", path.string(), "--port", printer_.address(),
                                            "--log-level", "error"});
  }

  static constexpr int kMoves = 10000;

  void send(int signal) { print_->send(signal); }
  int wait() { return print_->wait(); }
  [[nodiscard]] std::ptrdiff_t count(const std::string& command) const {
    return std::ranges::count(printer_.commands(), command);
  }
  [[nodiscard]] std::ptrdiff_t moves() const {
    return std::ranges::count_if(printer_.commands(), [](const std::string& command) {
      return command.starts_with("G1 X5") && command.ends_with(" E1");
    });
  }
  template <typename Condition>
  void until(Condition condition) const {
    for (int i = 0; i < 3000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
    REQUIRE(condition());
  }

 private:
  test::TemporaryFolder folder_;
  test::ObedientPrinter printer_;
  std::optional<test::ChildProcess> print_;
};

}  // namespace

TEST_CASE("Ctrl-Z parks the nozzle, and Ctrl-Z again goes on with the next line") {
  SignalledPrint print;
  print.until([&] { return print.moves() >= 20; });

  print.send(SIGTSTP);

  print.until([&] { return print.count("M400") == 1; });
  const auto moved = print.moves();
  CHECK(moved < SignalledPrint::kMoves);
  CHECK(print.count("G0 X5 Y215 F7200") == 1);
  print.send(SIGTSTP);
  CHECK(print.wait() == 0);
  CHECK(print.moves() == SignalledPrint::kMoves);
  CHECK(print.count("M109 S200") == 1);
}

TEST_CASE("A terminal that closes ends the print with the heaters off") {
  SignalledPrint print;
  print.until([&] { return print.moves() >= 20; });

  print.send(SIGHUP);

  CHECK(print.wait() == 130);
  CHECK(print.moves() < SignalledPrint::kMoves);
  CHECK(print.count("M104 S0") >= 1);
}
