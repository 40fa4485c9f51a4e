// The program `slipstick`: finds the command, runs it, turns its result into an exit status.
#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "host/commands/command.h"
#include "host/interrupt.h"
#include "host/process_memory.h"

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;
constexpr int kInterrupted = 130;

void set_up_logging(const std::string& level) {
  const auto logger = spdlog::stderr_color_mt("slipstick");
  logger->set_pattern("%H:%M:%S %l %v");
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(logger);
}

int status_of(const slipstick::CommandResult& result) {
  if (result) return *result;
  fmt::print(stderr, "slipstick: {}\n", result.error().message);
  return result.error().code == slipstick::ErrorCode::kCancelled ? kInterrupted : kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace slipstick;
  CLI::App app("Prints implicit solids straight from their function.", "slipstick");
  app.set_version_flag("--version", SLIPSTICK_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  std::string level = "warning";
  app.add_option("--log-level", level, "trace, debug, info, warning, error or off")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "off"}))
      ->capture_default_str();
  ChosenCommand run;
  add_slice_command(app, run);
  add_print_command(app, run, {argv + 1, argv + argc});
  add_sim_command(app, run);
  add_verify_command(app, run);
  add_convert_command(app, run);
  add_info_command(app, run);
  add_ports_command(app, run);
  add_bench_command(app, run);
  add_serve_command(app, run);
  add_figure_command(app, run);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  }
  keep_freed_memory();
  Interrupt::install();
  try {
    set_up_logging(level);
    return status_of(run());
  } catch (const std::exception& error) {
    fmt::print(stderr, "slipstick: {}\n", error.what());  // out of memory, in practice
    return kFailed;
  }
}
