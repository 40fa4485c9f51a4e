// A print that is cut off at every write, and taken up again, on the simulated printer in virtual
// time.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "host/journalled_print.h"
#include "host/pause.h"
#include "sim/sim_transport.h"
#include "tests/support/cut_transport.h"
#include "tests/support/spiral.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

constexpr int kNever = test::CutTransport::kNever;
constexpr double kFilament = 4;  // mm: of the program, whatever is drawn back and pushed meanwhile

// One print, from its beginning to its end, over as many cables as it takes.
class Bench {
 public:
  explicit Bench(std::vector<std::string> program) : program_(std::move(program)) {
    std::ofstream file(model());
    for (const std::string& line : program_) file << line << '\n';
  }

  Result<StreamOutcome> start(int writes) {
    JournalledPrint print(journal(), {folder_.path().string(), {"print"}, 0, 0});
    return run(print, writes);
  }
  Result<StreamOutcome> resume(int writes, Consent consent = Consent::kNone) {
    auto content = read_journal(journal());
    REQUIRE(content);
    JournalledPrint print(journal(), *std::move(content), consent);
    return run(print, writes);
  }
  // Pauses once `line` lines were sent; goes on after so many turns.
  void pause_at(std::uint64_t line, int turns) {
    pause_at_ = line;
    pause_turns_ = turns;
  }
  void change_model() { std::ofstream(model(), std::ios::app) << "G1 X1\n"; }
  // A new printer in the place of the old one.
  void lose_power() {
    sim_.run_down(std::chrono::hours(1));
    sim_now_ = std::make_unique<SimTransport>(*sim_options({}), test::into(later_));
  }
  std::vector<test::Bead> beads() {
    sim_.run_down(std::chrono::hours(1));
    return beads_;
  }
  std::vector<test::Bead> later_beads() {
    sim_now_->run_down(std::chrono::hours(1));
    return later_;
  }
  const Machine& machine() { return sim().printer().machine(); }
  std::filesystem::path journal() const { return folder_.path() / "a.journal"; }

 private:
  std::filesystem::path model() const { return folder_.path() / "a.gcode"; }
  SimTransport& sim() { return sim_now_ ? *sim_now_ : sim_; }

  Result<StreamOutcome> run(JournalledPrint& print, int writes) {
    test::CutTransport cable(sim(), writes);
    const Clock& clock = sim().clock();
    const PrintSettings settings;
    if (const auto ok = print.identify(model(), settings); !ok) return fail(ok.error());
    if (const auto ok = print.find(cable, clock); !ok) return fail(ok.error());
    test::ProgramLines source(program_);
    StreamOptions options{Pace::kVirtual, parking_place(settings)};
    const auto lines = print.begin(source, clock, options);
    if (!lines) return fail(lines.error());
    PrintControl* handle = nullptr;
    int turns = 0;
    PrintControl control({{}, [&](SenderState, const StreamFigures& figures) {
                            if (turns == 0 && figures.counters.lines_sent == pause_at_)
                              handle->pause();
                            if (handle->wish() == PrintControl::Wish::kPause &&
                                ++turns == pause_turns_)
                              handle->resume();
                          }});
    handle = &control;
    const auto outcome = stream_job(cable, clock, **lines, options, control);
    print.ended(outcome);
    return outcome;
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> program_;
  std::vector<test::Bead> beads_;
  std::vector<test::Bead> later_;
  SimTransport sim_{*sim_options({}), test::into(beads_)};
  std::unique_ptr<SimTransport> sim_now_;
  std::uint64_t pause_at_ = kNever;
  int pause_turns_ = 0;
};

std::vector<test::Bead> expected(const std::vector<std::string>& program) {
  Bench bench(program);
  REQUIRE(bench.start(kNever));
  return bench.beads();
}

bool nothing_was_laid(const Result<StreamOutcome>& outcome) {
  return !outcome && outcome.error().message.find("start the print again") != std::string::npos;
}

}  // namespace

TEST_CASE("A print cut off at any write is executed once and in order when it is taken up") {
  const std::vector<std::string> program = test::spiral(GENERATE("M82", "M83"));
  const auto whole = expected(program);
  REQUIRE(whole.size() == 40);

  int taken_up = 0;
  for (int cut = 1;; ++cut) {
    INFO("cut off at write " << cut);
    Bench bench(program);
    if (bench.start(cut)) break;
    const auto outcome = bench.resume(kNever);
    if (nothing_was_laid(outcome)) {
      CHECK(bench.beads().empty());
      continue;
    }
    INFO((outcome ? "" : outcome.error().message));
    REQUIRE(outcome);
    REQUIRE(bench.beads() == whole);
    REQUIRE(bench.machine().filament == Approx(kFilament));
    CHECK(read_journal(bench.journal())->end == JournalEnd::kFinished);
    ++taken_up;
  }

  CHECK(taken_up > 40);
}

TEST_CASE("A print cut off again and again while it is taken up is executed once and in order") {
  const std::vector<std::string> program = test::spiral("M83");
  const auto whole = expected(program);

  for (int writes = 4; writes < 20; ++writes) {
    INFO("cut off every " << writes << " writes");
    Bench bench(program);
    auto outcome = bench.start(25 + writes);
    for (int i = 0; i < 100 && !outcome; ++i) outcome = bench.resume(writes);
    INFO((outcome ? "" : outcome.error().message));
    if (writes > 8) REQUIRE(outcome);
    if (outcome) CHECK(bench.beads() == whole);
  }
}

TEST_CASE("A print cut off while it is parked, or on its way, comes back to where it was") {
  const std::vector<std::string> program = test::spiral(GENERATE("M82", "M83"));
  const auto whole = expected(program);

  for (int cut = 30; cut < 64; ++cut) {
    INFO("cut off at write " << cut);
    Bench bench(program);
    bench.pause_at(20, 30);
    REQUIRE(!bench.start(cut));
    bench.pause_at(kNever, 0);
    const auto outcome = bench.resume(kNever);
    INFO((outcome ? "" : outcome.error().message));
    REQUIRE(outcome);
    REQUIRE(bench.beads() == whole);
    REQUIRE(bench.machine().filament == Approx(kFilament));
  }
}

TEST_CASE("A printer that was reset moves and heats nothing before the user says so") {
  const std::vector<std::string> program = test::spiral("M83");
  Bench bench(program);
  REQUIRE(!bench.start(45));
  bench.lose_power();

  const auto outcome = bench.resume(kNever);

  REQUIRE(!outcome);
  CHECK_THAT(outcome.error().message, Contains("it can be recovered (--recover)"));
  CHECK(bench.machine().nozzle.target() == 0);
  CHECK(bench.machine().planner.statistics().moves == 0);
}

TEST_CASE("After a loss of power the print goes on a few lines before, at its height") {
  const std::vector<std::string> program = test::spiral(GENERATE("M82", "M83"));
  const auto whole = expected(program);
  Bench bench(program);
  REQUIRE(!bench.start(45));
  bench.lose_power();

  const auto outcome = bench.resume(kNever, Consent::kRecover);

  INFO((outcome ? "" : outcome.error().message));
  REQUIRE(outcome);
  const auto before = bench.beads();
  auto after = bench.later_beads();
  // The new machine was switched on at what it calls 0, at the height of the print.
  for (test::Bead& bead : after) bead[4] += 300;
  REQUIRE(after.size() < whole.size());
  CHECK(std::equal(after.rbegin(), after.rend(), whole.rbegin()));
  CHECK(before.size() + after.size() >= whole.size());
  CHECK(before.size() + after.size() <= whole.size() + 24);
}

TEST_CASE("A board that was reset is told again what the print has set up") {
  auto program = test::spiral("M83");
  program.insert(program.begin() + 4, {"M204 P700", "M221 S95"});
  Bench bench(program);
  REQUIRE(!bench.start(45));
  bench.lose_power();
  REQUIRE(bench.machine().limits.print_acceleration != 700);

  REQUIRE(bench.resume(kNever, Consent::kRecover));

  CHECK(bench.machine().limits.print_acceleration == 700);
  CHECK(bench.machine().flow_percent == 95);
}

TEST_CASE("Power lost while the nozzle was parked leaves its height unknown: nothing moves") {
  Bench bench(test::spiral("M83"));
  bench.pause_at(30, kNever);
  REQUIRE(!bench.start(44));
  bench.lose_power();

  const auto outcome = bench.resume(kNever, Consent::kRecover);

  REQUIRE(!outcome);
  CHECK_THAT(outcome.error().message, Contains("how high it stands is not known"));
  CHECK(bench.machine().planner.statistics().moves == 0);
}

TEST_CASE("A print is taken up with the model it began with, and not when it was finished") {
  Bench bench(test::spiral("M83"));
  REQUIRE(!bench.start(45));
  CHECK_THAT(bench.start(kNever).error().message, Contains("was not finished"));
  REQUIRE(bench.resume(kNever));
  CHECK_THAT(bench.resume(kNever).error().message, Contains("this print was finished"));

  bench.change_model();

  CHECK_THAT(bench.resume(kNever).error().message, Contains("not what it was"));
}
