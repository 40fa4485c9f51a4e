// Several lines under way: how full the wire is, and that nothing else changes.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "drivers/marlin/framing.h"
#include "host/stream_job.h"
#include "sim/sim_options.h"
#include "sim/sim_transport.h"
#include "tests/support/process.h"
#include "tests/support/spiral.h"

using namespace slipstick;

namespace {

/// Moves that lead nowhere: the wire is all that limits them.
std::vector<std::string> dust(int moves) {
  std::vector<std::string> lines{"G28", "M83"};
  lines.resize(lines.size() + static_cast<std::size_t>(moves), "G1 X100.125 Y100.250 F12000");
  return lines;
}

/// Counts what is written while moves are streamed.
class Counted final : public Transport {
 public:
  explicit Counted(SimTransport& sim) : sim_(sim) {}
  Result<std::size_t> read_some(std::span<char> buffer,
                                std::chrono::microseconds patience) override {
    return sim_.read_some(buffer, patience);
  }
  Result<std::size_t> write_some(std::string_view bytes,
                                 std::chrono::microseconds patience) override {
    auto count = sim_.write_some(bytes, patience);
    if (count) see(bytes.substr(0, *count));
    return count;
  }
  Result<void> write_all(std::string_view bytes, std::chrono::microseconds patience) override {
    see(bytes);
    return sim_.write_all(bytes, patience);
  }
  void shut_down() noexcept override { sim_.shut_down(); }
  [[nodiscard]] std::string_view name() const override { return sim_.name(); }

  /// The share of the wire's time that bytes took, from the first move of many to the last.
  [[nodiscard]] double share(int baud) const {
    const double seconds = std::chrono::duration<double>(last_ - first_).count();
    return static_cast<double>(bytes_) * 10 / baud / seconds;
  }

 private:
  void see(std::string_view bytes) {
    constexpr int kWarmUp = 200;
    const bool move = bytes.find("G1 ") != std::string_view::npos;
    if (move && ++lines_ == kWarmUp) first_ = sim_.clock().now();
    if (lines_ <= kWarmUp) return;
    bytes_ += bytes.size();
    if (move) last_ = sim_.clock().now();
  }

  SimTransport& sim_;
  int lines_ = 0;
  std::size_t bytes_ = 0;
  Moment first_{};
  Moment last_{};
};

double wire_share(int baud, int window, const char* latency = "0") {
  SimTransport sim(*sim_options({{"baud", std::to_string(baud)}, {"latency", latency}}));
  Counted counted(sim);
  test::ProgramLines lines(dust(4000));
  StreamOptions options{Pace::kVirtual};
  options.sender.window = window;
  const auto outcome = stream_job(counted, sim.clock(), lines, options);
  REQUIRE(outcome);
  CHECK(outcome->counters.resends == 0);
  CHECK((outcome->counters.lines_behind > 0) == (window > 0));
  CHECK(sim.printer().statistics().bytes_overrun == 0);
  return counted.share(baud);
}

}  // namespace

TEST_CASE("A window keeps a slow wire full") {
  for (const int baud : {115200, 250000}) {
    INFO(baud);
    const double one = wire_share(baud, 0);
    const double several = wire_share(baud, 96);
    INFO(one << " and " << several);
    CHECK(several >= 0.95);
    CHECK(one < several);
  }
}

TEST_CASE("Behind an adapter with a slow timer a window sends more than twice as much") {
  // Of an answer each 16 ms one line at a time makes a line each 16 ms, 3 ms of the wire.
  const double one = wire_share(115200, 0, "16");
  const double several = wire_share(115200, 120, "16");
  CHECK(one == Approx(0.19).margin(0.03));
  CHECK(several > 2.5 * one);
}

TEST_CASE("A print through a window lays the same beads") {
  const std::vector<std::string> program = test::spiral("M83");
  std::vector<std::vector<test::Bead>> beads(2);
  for (const int window : {0, 96}) {
    auto& laid = beads[window > 0 ? 1 : 0];
    SimTransport sim(*sim_options({{"baud", "115200"}}), test::into(laid));
    test::ProgramLines lines(program);
    StreamOptions options{Pace::kVirtual};
    options.sender.window = window;
    options.sender.proving = 4;
    const auto outcome = stream_job(sim, sim.clock(), lines, options);
    REQUIRE(outcome);
    CHECK((outcome->counters.lines_behind > 0) == (window > 0));
    sim.run_down(std::chrono::hours(1));
    for (test::Bead& bead : laid) bead.back() = 0;  // starved of lines, a machine is slower
  }
  CHECK_FALSE(beads[0].empty());
  CHECK(beads[0] == beads[1]);
}

void check_never_dry(const std::string& baud) {
  const std::string port = "sim:?baud=" + baud;
  const std::string model = SLIPSTICK_SOURCE_DIR "/configs/solids/bracket.lua";
  const auto done =
      test::slipstick({"print", model, "--port", port, "--set", "window=96", "--layer-height",
                       "0.3", "--sampling", "0.2", "--certify", "off", "--json"});
  INFO(done.err);
  REQUIRE(done.status == 0);
  const auto report = nlohmann::json::parse(done.out);
  CHECK(report["sim"]["underruns"] == 0);
  CHECK(report["sim"]["deposit"]["components_wrong"] == 0);
  CHECK(report["sim"]["deposit"]["holes_wrong"] == 0);
  CHECK(report["printer"]["resends"] == 0);
}

TEST_CASE("Through a window the planner never runs dry at 115200 baud") {
  check_never_dry("115200");
}

TEST_CASE("Through a window the planner never runs dry at 250000 baud") {
  check_never_dry("250000");
}
