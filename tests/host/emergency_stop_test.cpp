// An emergency stop on a real terminal that nobody reads and that takes nothing any more.
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <future>

#include "drivers/fd_transport.h"
#include "drivers/pty_transport.h"
#include "host/stream_job.h"

using namespace slipstick;
using namespace std::chrono_literals;

namespace {

class NoLines final : public LineSource {
 public:
  Result<std::optional<Line>> next() override { return std::optional<Line>(); }
  bool ready() const override { return false; }
};

// The printer's side of a terminal, and ours.
struct Terminal {
  Terminal() {
    UniqueFd master(::posix_openpt(O_RDWR | O_NOCTTY));
    REQUIRE((::grantpt(master.get()) == 0 && ::unlockpt(master.get()) == 0));
    host = *open_pty(::ptsname(master.get()));
    printer = *FdTransport::adopt(std::move(master), "test:printer");
  }
  std::unique_ptr<FdTransport> printer;
  std::unique_ptr<Transport> host;
};

// How long after the request M112 can be read at the other end.
Moment latency(bool full) {
  Terminal terminal;
  if (full) {
    const std::string noise(1 << 20, 'x');
    REQUIRE_FALSE(terminal.host->write_all(noise, 0us));
  }
  const SteadyClock clock;
  NoLines lines;
  std::promise<void> said;
  bool first = true;
  PrintControl control({{}, [&](SenderState state, const StreamFigures&) {
                          if (first && state == SenderState::kHalted) said.set_value();
                          first &= state != SenderState::kHalted;
                        }});
  auto print = std::async(std::launch::async, [&] {
    return stream_job(*terminal.host, clock, lines, {Pace::kRealTime, {}}, control);
  });
  std::array<char, 8192> buffer{};
  (void)terminal.printer->read_some(std::span(buffer).first(1), 100ms);
  const Moment asked = clock.now();
  control.emergency_stop();
  said.get_future().wait();  // Before that the other end would only make room for old bytes.

  std::string heard;
  while (heard.find("\nM112\n") == std::string::npos && clock.now() < asked + 3s) {
    const auto got = terminal.printer->read_some(buffer, 100ms);
    if (got) heard.append(buffer.data(), *got);
  }
  const Moment took = clock.now() - asked;
  const auto outcome = print.get();
  REQUIRE_FALSE(outcome);
  CHECK_THAT(outcome.error().message, Catch::Contains("did not confirm the emergency stop"));
  // What the other end had in hand already cannot be taken back; the rest is not waited for.
  constexpr std::size_t kTerminalHolds = 4096;
  REQUIRE(heard.find("\nM112\n") <= 2 * kTerminalHolds);
  return took;
}

}  // namespace

TEST_CASE("M112 is on the wire within 50 ms, also when the port takes nothing any more") {
  const bool full = GENERATE(false, true);
  constexpr int kTries = 5;  // the machine that tests may be busy

  Moment best = 1h;
  for (int attempt = 0; attempt < kTries && best > 50ms; ++attempt) {
    best = std::min(best, latency(full));
  }

  CHECK(best <= 50ms);
}
