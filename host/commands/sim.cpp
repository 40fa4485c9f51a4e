// `slipstick sim --pty PATH`: the simulated printer on its own, for any host program.
#include <fmt/format.h>

#include <chrono>
#include <stop_token>
#include <thread>

#include "host/commands/command.h"
#include "host/interrupt.h"
#include "sim/pty_server.h"
#include "sim/sim_transport.h"

namespace slipstick {
namespace {

struct SimCommand {
  std::string pty;
  int tcp = -1;
  std::string options;
};

std::map<std::string, std::string> options_of(const SimCommand& command) {
  std::map<std::string, std::string> options;
  std::string_view rest = command.options;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('&'), rest.size());
    const std::string_view word = rest.substr(0, end);
    const std::size_t equals = std::min(word.find('='), word.size());
    options.emplace(word.substr(0, equals), word.substr(std::min(equals + 1, word.size())));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return options;
}

CommandResult run_sim(const SimCommand& command) {
  using namespace std::chrono_literals;
  const auto options = sim_options(options_of(command));
  if (!options) return fail(options.error());
  PtyServerOptions where{command.pty, {}};
  if (command.tcp >= 0) where.tcp_port = command.tcp;
  auto server = PtyServer::open(where, Printer(options->printer));
  if (!server) return fail(server.error());
  if (!command.pty.empty()) fmt::print("printer at {} ({})\n", command.pty, server->device());
  if (command.tcp >= 0) fmt::print("printer at 127.0.0.1:{}\n", server->tcp_port());
  std::fflush(stdout);
  std::stop_source stop;
  const std::jthread watcher([&stop](const std::stop_token& over) {
    while (!over.stop_requested() && !Interrupt::requested()) std::this_thread::sleep_for(50ms);
    stop.request_stop();
  });
  if (const auto ok = server->run(stop.get_token()); !ok) return fail(ok.error());
  return 0;
}

}  // namespace

void add_sim_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<SimCommand>();
  CLI::App* sub =
      app.add_subcommand("sim", "a simulated printer for any host program, in real time");
  auto* pty = sub->add_option("--pty", command->pty, "where to put the link to its terminal");
  auto* tcp = sub->add_option("--tcp", command->tcp, "port on 127.0.0.1; 0 chooses one")
                  ->check(CLI::Range(0, 65535));
  sub->add_option("--options", command->options,
                  "as behind 'sim:?': seed=7&corrupt=0.002&baud=115200");
  sub->footer("Example: slipstick sim --pty /tmp/printer");
  sub->callback([command, &run, pty, tcp] {
    if (pty->count() + tcp->count() == 0) throw CLI::RequiredError("--pty or --tcp");
    run = [command] { return run_sim(*command); };
  });
}

}  // namespace slipstick
