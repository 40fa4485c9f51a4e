#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/base/check.h"
#include "host/stream_job.h"
#include "sim/pty_server.h"
#include "sim/sim_transport.h"
#include "tests/support/spiral.h"

namespace slipstick::test {

/// Beads that take no time to speak of, and no heat.
inline std::vector<std::string> quick_program(std::uint64_t beads) {
  std::vector<std::string> lines{"M302 S0", "M83", "G92 E0", "G1 X100 Y100 Z0.3 F12000"};
  for (std::uint64_t i = 0; i < beads; ++i) {
    lines.push_back("G1 X" + std::to_string(100 + i % 2 * 3) + " Y" + std::to_string(60 + i % 89) +
                    " E0.05");
  }
  return lines;
}

/// A simulated printer behind a terminal, in real time, with a life of its own.
class LivePrinter {
 public:
  explicit LivePrinter(const std::filesystem::path& link)
      : server_(*PtyServer::open({link.string(), {}},
                                 Printer({},
                                         [this, sink = into(beads_)](const ExecutedMove& move) {
                                           const std::lock_guard lock(mutex_);
                                           sink(move);
                                         }))),
        thread_([this](const std::stop_token& stop) { SLIPSTICK_CHECK(server_.run(stop)); }) {}

  /// Any thread, as the next.
  std::vector<Bead> beads() const {
    const std::lock_guard lock(mutex_);
    return beads_;
  }
  std::size_t count() const {
    const std::lock_guard lock(mutex_);
    return beads_.size();
  }

 private:
  mutable std::mutex mutex_;  // protects the beads
  std::vector<Bead> beads_;
  PtyServer server_;
  std::jthread thread_;
};

/// Starved of lines now and then, a machine is slower.
inline std::vector<Bead> without_speed(std::vector<Bead> beads) {
  for (Bead& bead : beads) bead.back() = 0;
  return beads;
}

/// What a machine lays of a program that nobody disturbs.
inline std::vector<Bead> quick_beads(const std::vector<std::string>& program) {
  std::vector<Bead> beads;
  SimTransport sim(*sim_options({}), into(beads));
  ProgramLines lines(program);
  SLIPSTICK_CHECK(stream_job(sim, sim.clock(), lines, {Pace::kVirtual}));
  sim.run_down(std::chrono::hours(1));
  return without_speed(beads);
}

}  // namespace slipstick::test
