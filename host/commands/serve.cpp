// `slipstick serve`: the daemon.
#include <fmt/format.h>

#include <cstdlib>

#include "host/commands/command.h"
#include "host/interrupt.h"
#include "host/serve/daemon.h"

namespace slipstick {
namespace {

// Where services keep their state, or a user his data.
std::string default_data_folder() {
  if (const char* state = std::getenv("STATE_DIRECTORY")) return state;  // of systemd
  if (const char* data = std::getenv("XDG_DATA_HOME")) return std::string(data) + "/slipstick";
  const char* home = std::getenv("HOME");
  return home == nullptr ? "/var/lib/slipstick" : std::string(home) + "/.local/share/slipstick";
}

CommandResult run_serve(const Daemon::Options& options) {
  const auto daemon = Daemon::start(options);
  if (!daemon) return fail(daemon.error());
  fmt::print("listening on {}\n", (*daemon)->url());
  if (!(*daemon)->key().empty()) {
    fmt::print("clients need the key in {}\n", (options.data / "api_key").string());
  }
  std::fflush(stdout);
  (*daemon)->run([] { return !Interrupt::requested(); });
  return 0;
}

}  // namespace

void add_serve_command(CLI::App& app, ChosenCommand& run) {
  const auto options = std::make_shared<Daemon::Options>();
  options->data = default_data_folder();
  options->port = "sim:?realtime=1";
  CLI::App* sub = app.add_subcommand("serve", "the daemon: job queue, HTTP API");
  sub->add_option("--data", options->data, "folder for jobs and files")->capture_default_str();
  sub->add_option("--listen", options->listen, "HOST:PORT; off this machine a key is needed")
      ->capture_default_str();
  sub->add_option("--printer", options->port,
                  "/dev/ttyUSB0, usb:VID:PID[:SERIAL], pty:PATH, tcp:HOST:PORT or sim:")
      ->capture_default_str();
  sub->add_option("--machine", options->defaults.printer,
                  "settings of jobs that do not say otherwise: name from configs/printers")
      ->capture_default_str();
  sub->add_option("--material", options->defaults.material, "likewise, from configs/materials")
      ->capture_default_str();
  sub->add_option("--profile", options->defaults.profile, "likewise, from configs/profiles");
  sub->footer("Example: slipstick serve --printer /dev/ttyUSB0 --machine ender3");
  sub->callback([options, &run] { run = [options] { return run_serve(*options); }; });
}

}  // namespace slipstick
