// The sender over a real pseudo-terminal, against a printer that acknowledges each line at once, or
// every millisecond. One line in flight. Journals are not part of it.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "core/base/check.h"
#include "drivers/pty_transport.h"
#include "host/stream_job.h"
#include "tests/bench/targets/echo.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

namespace {

using Steady = std::chrono::steady_clock;
using std::chrono::microseconds;

constexpr int kRounds = 7;

/// Notes how long it takes from an acknowledgement read to the next line written.
class Timed final : public Transport {
 public:
  explicit Timed(std::unique_ptr<Transport> inner) : inner_(std::move(inner)) {}

  Result<std::size_t> read_some(std::span<char> buffer, microseconds patience) override {
    auto count = inner_->read_some(buffer, patience);
    if (count) read_at_ = Steady::now();
    return count;
  }
  Result<std::size_t> write_some(std::string_view bytes, microseconds patience) override {
    auto count = inner_->write_some(bytes, patience);
    note();
    return count;
  }
  Result<void> write_all(std::string_view bytes, microseconds patience) override {
    auto done = inner_->write_all(bytes, patience);
    note();
    return done;
  }
  void shut_down() noexcept override { inner_->shut_down(); }
  [[nodiscard]] int descriptor() const noexcept override { return inner_->descriptor(); }
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }

  /// Microseconds within which a share of the lines were sent.
  [[nodiscard]] double within(double share) {
    SLIPSTICK_CHECK(!took_.empty());
    const auto at = static_cast<std::size_t>(share * static_cast<double>(took_.size() - 1));
    std::nth_element(took_.begin(), took_.begin() + static_cast<std::ptrdiff_t>(at), took_.end());
    return took_[at];
  }

 private:
  void note() {
    if (read_at_ == Steady::time_point()) return;
    took_.push_back(std::chrono::duration<double, std::micro>(Steady::now() - read_at_).count());
    read_at_ = {};
  }

  std::unique_ptr<Transport> inner_;
  Steady::time_point read_at_;
  std::vector<double> took_;
};

class Moves final : public LineSource {
 public:
  explicit Moves(int count) : left_(count) {}
  Result<std::optional<Line>> next() override {
    if (left_ == 0) return std::optional<Line>();
    --left_;
    return normalise(fmt::format("G1 X{}.{:03} Y{}.{:03} E0.04125", 100 + left_ % 20, left_ % 1000,
                                 80 + left_ % 30, left_ * 7 % 1000));
  }
  [[nodiscard]] bool ready() const override { return true; }

 private:
  int left_;
};

double thread_seconds() {
  timespec t{};
  SLIPSTICK_CHECK(::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t) == 0);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

struct Run {
  double lines_per_second;
  double median;   ///< µs
  double worst99;  ///< µs
  double cpu;      ///< Share of a core.
};

Run send(int lines, microseconds pause) {
  Echo echo(pause);
  auto terminal = open_pty(echo.path());
  SLIPSTICK_CHECK(terminal.has_value());
  echo.start();
  Timed timed(std::move(*terminal));
  const SteadyClock clock;
  Moves moves(lines);
  StreamOptions options;
  options.sender.banner_wait = std::chrono::milliseconds(1);
  const double cpu = thread_seconds();
  const auto outcome = stream_job(timed, clock, moves, options);
  SLIPSTICK_CHECK(outcome.has_value());
  SLIPSTICK_CHECK(outcome->counters.lines_acknowledged == static_cast<std::uint64_t>(lines));
  return {lines / outcome->seconds, timed.within(0.5), timed.within(0.99),
          (thread_seconds() - cpu) / outcome->seconds};
}

/// By the middle of `kRounds`, its value and how far the rounds lie apart.
struct Spread {
  double low;
  double middle;
  double high;
};
Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

}  // namespace

std::vector<Row> sender_rows() {
  std::vector<double> rates;
  std::vector<double> medians;
  std::vector<double> worsts;
  for (int i = 0; i < kRounds; ++i) {
    const Run run = send(40'000, microseconds(0));
    rates.push_back(run.lines_per_second);
    medians.push_back(run.median);
    worsts.push_back(run.worst99);
  }
  std::vector<double> shares;
  for (int i = 0; i < kRounds; ++i) shares.push_back(100 * send(2'000, microseconds(1000)).cpu);
  const Spread rate = spread(rates);
  const Spread median = spread(medians);
  const Spread worst = spread(worsts);
  const Spread share = spread(shares);
  return {{"lines a second over a pseudo-terminal, one in flight", "≥ 20,000",
           fmt::format("{:.0f} ({:.0f} to {:.0f})", rate.middle, rate.low, rate.high),
           rate.middle >= 20'000},
          {"from ok read to the next line written, 99 of 100 within", "< 200 µs",
           fmt::format("{:.1f} µs ({:.1f} to {:.1f}), half within {:.1f} µs", worst.middle,
                       worst.low, worst.high, median.middle),
           worst.middle < 200},
          {"of a core at 1,000 lines a second", "< 5 %",
           fmt::format("{:.1f} % ({:.1f} to {:.1f})", share.middle, share.low, share.high),
           share.middle < 5}};
}

}  // namespace slipstick::targets
