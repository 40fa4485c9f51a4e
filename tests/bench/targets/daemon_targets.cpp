// The daemon as a process, printing a program over a pseudo-terminal on a printer that acknowledges
// a line every millisecond: how soon the next line follows, and how much memory it takes, with and
// without listeners and requests. Rounds with and without alternate, so that what else the machine
// does disturbs both.
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "core/base/check.h"
#include "tests/bench/targets/echo.h"
#include "tests/bench/targets/targets.h"
#include "tests/support/daemon_process.h"
#include "tests/support/http_client.h"
#include "tests/support/temporary_folder.h"

namespace slipstick::targets {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

constexpr int kRounds = 7;
constexpr int kLines = 8'000;
constexpr int kListeners = 50;
constexpr auto kBetweenRequests = 50ms;
constexpr auto kIdle = 30s;

std::string program() {
  std::string text = "G90\nM83\n";
  for (int i = 0; i < kLines; ++i) {
    text += fmt::format("G1 X{}.{:03} Y{}.{:03} E0.04125\n", 100 + i % 20, i % 1000, 80 + i % 30,
                        i * 7 % 1000);
  }
  return text;
}

json asked(std::uint16_t port, std::string_view method, std::string_view target,
           std::string_view body = "") {
  const auto reply = test::request(port, method, target, body);
  SLIPSTICK_CHECK(reply.status >= 200 && reply.status < 300);
  return reply.body.empty() ? json() : json::parse(reply.body);
}

double resident_mb(pid_t process) {
  std::ifstream status(fmt::format("/proc/{}/status", process));
  for (std::string word; status >> word;) {
    double kib = 0;
    if (word == "VmRSS:" && status >> kib) return kib / 1024;
  }
  return 0;
}

double cpu_seconds(pid_t process) {
  std::ifstream stat(fmt::format("/proc/{}/stat", process));
  std::string text(std::istreambuf_iterator<char>(stat), {});
  std::istringstream rest(text.substr(text.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) rest >> skipped;
  double user = 0, system = 0;
  rest >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Clients that listen to events, and one that asks again and again.
class Load {
 public:
  explicit Load(std::uint16_t port) {
    for (int i = 0; i < kListeners; ++i) {
      listeners_.emplace_back(port).send("GET /api/v1/events HTTP/1.1\r\nHost: localhost\r\n\r\n");
      SLIPSTICK_CHECK(listeners_.back().read_until("\n\n").find(" 200 ") != std::string::npos);
    }
    listening_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        for (test::HttpClient& each : listeners_) SLIPSTICK_CHECK(!each.ended_within(0ms));
        std::this_thread::sleep_for(20ms);
      }
    });
    asking_ = std::jthread([port](const std::stop_token& stop) {
      constexpr std::array kTargets{"/api/v1/printer", "/api/v1/jobs", "/api/v1/files", "/metrics"};
      auto due = std::chrono::steady_clock::now();
      for (std::size_t i = 0; !stop.stop_requested(); ++i) {
        SLIPSTICK_CHECK(test::request(port, "GET", kTargets[i % kTargets.size()]).status == 200);
        due += kBetweenRequests;
        std::this_thread::sleep_until(due);
      }
    });
  }

 private:
  std::deque<test::HttpClient> listeners_;
  std::jthread listening_;
  std::jthread asking_;
};

struct Round {
  double half = 0;   ///< µs
  double worst = 0;  ///< µs: 99 of 100 within.
  double memory = 0;
};

class Site {
 public:
  Site() { echo_.start(); }

  /// Idle, with the printer connected. \return MB and the share of a core, %.
  [[nodiscard]] std::pair<double, double> idle() const {
    while (!asked(port(), "GET", "/api/v1/printer")["connected"])
      std::this_thread::sleep_for(100ms);
    const double before = cpu_seconds(daemon_.pid());
    std::this_thread::sleep_for(kIdle);
    const double used = cpu_seconds(daemon_.pid()) - before;
    return {resident_mb(daemon_.pid()), 100 * used / std::chrono::duration<double>(kIdle).count()};
  }

  [[nodiscard]] Round print() const {
    asked(port(), "PUT", "/api/v1/files/a.gcode", program());
    asked(port(), "POST", "/api/v1/printer/bed-cleared");
    const json job = asked(port(), "POST", "/api/v1/jobs", R"({"file": "a.gcode"})");
    const std::string target = fmt::format("/api/v1/jobs/{}", job["id"].get<int>());
    json now = job;
    Round round;
    while (now["state"] == "queued" || now["state"] == "printing") {
      std::this_thread::sleep_for(500ms);
      now = asked(port(), "GET", target);
      round.memory = std::max(round.memory, resident_mb(daemon_.pid()));
    }
    SLIPSTICK_CHECK(now["state"] == "done" && now["result"]["lines"] >= kLines);
    round.half = 1e6 * now["result"]["turnaround_p50"].get<double>();
    round.worst = 1e6 * now["result"]["turnaround_p99"].get<double>();
    return round;
  }

  [[nodiscard]] std::uint16_t port() const { return daemon_.port(); }

 private:
  test::TemporaryFolder folder_;
  Echo echo_{1ms};
  test::DaemonProcess daemon_{folder_.path(), "pty:" + echo_.path()};
};

struct Rounds {
  std::vector<Round> all = {};

  [[nodiscard]] double middle(double Round::*member) const {
    std::vector<double> values = sorted(member);
    return values[values.size() / 2];
  }
  [[nodiscard]] std::string worst_text() const {
    const std::vector<double> values = sorted(&Round::worst);
    return fmt::format("{:.0f} µs ({:.0f} to {:.0f}), half within {:.0f} µs", middle(&Round::worst),
                       values.front(), values.back(), middle(&Round::half));
  }
  [[nodiscard]] std::vector<double> sorted(double Round::*member) const {
    std::vector<double> values;
    for (const Round& round : all) values.push_back(round.*member);
    std::sort(values.begin(), values.end());
    return values;
  }
};

}  // namespace

std::vector<Row> daemon_rows() {
  const Site site;
  const auto [idle_mb, idle_share] = site.idle();
  static_cast<void>(site.print());  // what is loaded once
  Rounds quiet, loaded;
  for (int i = 0; i < kRounds; ++i) {
    quiet.all.push_back(site.print());
    const Load load(site.port());
    loaded.all.push_back(site.print());
  }
  const double times = loaded.middle(&Round::worst) / quiet.middle(&Round::worst);
  const double more = loaded.sorted(&Round::memory).back() - quiet.sorted(&Round::memory).front();
  return {
      {"daemon, printer connected, nothing to do for 30 s", "≤ 32 MB, ≤ 2 % of a core",
       fmt::format("{:.1f} MB, {:.1f} %", idle_mb, idle_share), idle_mb <= 32 && idle_share <= 2},
      {"from ok read to the next line written, 99 of 100 within, in the daemon", "< 200 µs",
       quiet.worst_text(), quiet.middle(&Round::worst) < 200},
      {"the same with 50 listeners to events and 20 requests a second", "≤ 20 % more",
       fmt::format("{}: {:+.0f} %", loaded.worst_text(), 100 * (times - 1)), times <= 1.2},
      {"memory with them", "≤ 20 MB more",
       fmt::format("{:.1f} MB against {:.1f} MB", loaded.sorted(&Round::memory).back(),
                   quiet.sorted(&Round::memory).front()),
       more <= 20}};
}

}  // namespace slipstick::targets
