// kill -9 at moments drawn from a seed, while the printer lives on: the job is executed once and in
// order all the same. SLIPSTICK_KILLS=200 for as many; SLIPSTICK_SEED=S for other moments.
#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <thread>

#include "core/base/rng.h"
#include "tests/support/child_process.h"
#include "tests/support/environment.h"
#include "tests/support/live_printer.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using namespace std::chrono_literals;

namespace {

constexpr std::uint64_t kLinesPerKill = 30;  // at most, so that none comes after the end

class Voyage {
 public:
  Voyage(std::uint64_t seed, std::uint64_t kills)
      : rng_(seed), kills_(kills), program_(test::quick_program((kills + 1) * kLinesPerKill)) {
    std::ofstream file(model_);
    for (const std::string& line : program_) file << line << '\n';
  }

  void sail() {
    for (std::uint64_t i = 0; i < kills_; ++i) {
      INFO("kill " << i);
      live_and_die();
    }
    // The rest, without a disturbance; from the beginning if nothing was ever sent.
    while (begin().wait() != 0) start_again();
    CHECK(test::without_speed(printed_after(20s)) == test::quick_beads(program_));
    CHECK(in_the_middle_ > kills_ / 2);  // or the voyage shows nothing
  }

 private:
  test::ChildProcess begin() {
    if (std::filesystem::exists(journal_))
      return test::ChildProcess({"print", "--resume", journal_});
    return test::ChildProcess({"print", model_, "--port", "pty:" + port_, "--journal", journal_});
  }

  void live_and_die() {
    auto print = begin();
    const std::size_t before = printer_.count();
    const std::size_t enough = before + rng_.below(kLinesPerKill - 10);
    const auto at_most = std::chrono::milliseconds(1000 + rng_.below(6000));
    const auto until = std::chrono::steady_clock::now() + at_most;
    while (printer_.count() < enough && std::chrono::steady_clock::now() < until)
      std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(std::chrono::microseconds(rng_.below(5000)));
    print.send(SIGKILL);
    const int status = print.wait();
    if (status == 1) start_again();
    if (printer_.count() > before) ++in_the_middle_;
  }

  // A print of which nothing was laid is not taken up.
  void start_again() {
    REQUIRE(printer_.count() == 0);
    std::filesystem::remove(journal_);
  }

  std::vector<test::Bead> printed_after(std::chrono::seconds most) {
    const auto until = std::chrono::steady_clock::now() + most;
    while (printer_.count() < program_.size() - 4 && std::chrono::steady_clock::now() < until)
      std::this_thread::sleep_for(10ms);
    return printer_.beads();
  }

  test::TemporaryFolder folder_;
  std::string port_ = (folder_.path() / "printer").string();
  std::string model_ = (folder_.path() / "a.gcode").string();
  std::string journal_ = (folder_.path() / "a.journal").string();
  test::LivePrinter printer_{port_};
  Rng rng_;
  std::uint64_t kills_;
  std::uint64_t in_the_middle_ = 0;
  std::vector<std::string> program_;
};

}  // namespace

TEST_CASE("Killed at any moment and taken up again, a print is executed once and in order") {
  const std::uint64_t seed = test::from_environment("SLIPSTICK_SEED", 1);
  const std::uint64_t kills = test::from_environment("SLIPSTICK_KILLS", 4);
  INFO("SLIPSTICK_SEED=" << seed << " SLIPSTICK_KILLS=" << kills);
  Voyage voyage(seed, kills);

  voyage.sail();
}
