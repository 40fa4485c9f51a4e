// How fast the simulated printer prints, and what it keeps: the example, line after line over the
// wire, each when the one before it is acknowledged.
#include <fmt/format.h>

#include <array>
#include <string>

#include "core/base/check.h"
#include "host/process_memory.h"
#include "host/slicing_job.h"
#include "sim/deposit.h"
#include "sim/printer.h"
#include "tests/bench/subjects.h"
#include "tests/bench/targets/child_process.h"
#include "tests/bench/targets/targets.h"

namespace slipstick::targets {

using namespace bench;

namespace {

std::string example_program() {
  SlicingRequest request;
  request.threads = 2;
  auto job = SlicingJob::start(example_on_bed(), request);
  SLIPSTICK_CHECK(job.has_value());
  std::string text = "G28\nM83\nM109 S210\n";
  while (true) {
    const auto layer = (*job)->next();
    SLIPSTICK_CHECK(layer.has_value());
    if (!*layer) return text;
    text += (*layer)->program.value().text;
  }
}

class WiredPrinter {
 public:
  WiredPrinter()
      : deposit_(1.75, [this](const ExtrudedSegment& /*bead*/) { ++beads_; }),
        printer_({}, [this](const ExecutedMove& move) { deposit_.add(move); }) {
    printer_.advance(Firmware::kBootTime);
    listen();
  }

  void obey(std::string_view line) {
    printer_.receive(std::string(line).append("\n"), printer_.now());
    printer_.advance(printer_.now());
    while (!listen()) {
      const auto next = printer_.next_event();
      SLIPSTICK_CHECK(next.has_value());
      printer_.advance(*next);
    }
  }

  [[nodiscard]] double hours() const {
    return std::chrono::duration<double>(printer_.now()).count() / 3600;
  }
  [[nodiscard]] std::int64_t beads() const { return beads_; }

 private:
  /// \return Whether the board acknowledged.
  bool listen() {
    std::array<char, 4096> buffer{};
    const std::size_t count = printer_.take(buffer);
    return std::string_view(buffer.data(), count).find("ok") != std::string_view::npos;
  }

  std::int64_t beads_ = 0;
  Deposit deposit_;
  Printer printer_;
};

/// Prints `program` until `hours` have passed, again and again if it ends before.
void print_for(double hours, std::string_view program) {
  WiredPrinter printer;
  while (printer.hours() < hours) {
    for (std::string_view rest = program; !rest.empty() && printer.hours() < hours;) {
      const std::size_t end = rest.find('\n');
      if (rest.front() != ';') printer.obey(rest.substr(0, end));
      rest.remove_prefix(end + 1);
    }
  }
  SLIPSTICK_CHECK(printer.beads() > 0);
}

double printing_mb(double hours, std::string_view program) {
  return in_child([&] {
    const double before = begin_peak_anew();
    print_for(hours, program);
    return peak_mb() - before;
  });
}

}  // namespace

std::vector<Row> simulation_rows() {
  const std::string program = example_program();
  const Timing hour = cpu_seconds(5, [&] { print_for(1, program); });
  const double one = printing_mb(1, program);
  const double ten = printing_mb(10, program);
  return {{"an hour of the example on the simulated printer, wire and deposit included", "< 2 s",
           hour.text("ms"), hour.most < 2},
          {"memory that ten hours of it take beyond one", "0 MB",
           fmt::format("{:.1f} MB and {:.1f} MB", one, ten), ten <= one + 0.5}};
}

}  // namespace slipstick::targets
