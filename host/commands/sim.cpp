// `slipstick sim --pty PATH`: the simulated printer on its own, for any host program.
// `slipstick sim --gcode FILE --against MODEL`: what a program prints, judged by the model.
#include <fmt/format.h>

#include <chrono>
#include <stop_token>
#include <thread>

#include "host/atomic_file.h"
#include "host/commands/command.h"
#include "host/gcode_judge.h"
#include "host/gcode_judge_report.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/outputs/curves_picture.h"
#include "host/outputs/deposit_picture.h"
#include "sim/faults/fault_names.h"
#include "sim/pty_server.h"
#include "sim/sim_transport.h"

namespace slipstick {
namespace {

struct SimCommand {
  std::string pty;
  int tcp = -1;
  std::string control;
  double speed = 1;
  std::string options;
  std::vector<std::string> faults;
  std::string gcode;
  ModelOptions against;
  SlicingOptions slicing;
  bool json = false;
  std::string picture;
  int picture_layer = -1;
  std::string curves;
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
  auto options = sim_options(options_of(command));
  if (!options) return fail(options.error());
  for (const std::string& text : command.faults) {
    const auto fault = FaultSpec::parse(text);
    if (!fault) return fail(fault.error());
    options->printer.faults.push_back(*fault);
  }
  PtyServerOptions where{command.pty, {}, command.speed, command.control};
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

/// The pictures that were asked for.
class Drawings {
 public:
  explicit Drawings(const SimCommand& command)
      : command_(command),
        picture_(command.picture_layer < 0 ? std::nullopt : std::optional(command.picture_layer)) {}

  /// What they are drawn from. \pre This stays where it is.
  GcodeWatch watch() {
    GcodeWatch watch;
    if (!command_.picture.empty()) {
      watch.layers = [this](int layer, double top, const JudgedLayer& judged) {
        picture_.see(layer, top, judged);
      };
    }
    if (!command_.curves.empty()) {
      watch.machine = [this](Moment now, const Machine& machine) { curves_.see(now, machine); };
      watch.moves = [this](const ExecutedMove& move) { curves_.add(move); };
    }
    return watch;
  }

  Result<void> write(const GcodeVerdict& verdict) const {
    if (!command_.picture.empty()) {
      const auto drawn = picture_.write_to(command_.picture, verdict.print.defects);
      if (!drawn) return drawn;
    }
    return command_.curves.empty() ? Result<void>() : draw_curves(curves_, command_.curves);
  }

 private:
  const SimCommand& command_;
  DepositPicture picture_;
  Curves curves_;
};

CommandResult run_judge(const SimCommand& command) {
  const auto request = command.slicing.request(SliceGoal::kContours);
  if (!request) return fail(request.error());
  const auto loaded = command.against.load();
  if (!loaded) return fail(loaded.error());
  const auto placed = place_on_bed(*loaded->model, command.against.placement(),
                                   bed_centre(request->settings.printer));
  if (!placed) return fail(placed.error().within(loaded->name));
  Drawings drawings(command);
  const auto verdict = judge_gcode(command.gcode, *placed, request->settings, drawings.watch());
  if (!verdict) return fail(verdict.error());
  if (const auto ok = drawings.write(*verdict); !ok) return fail(ok.error());
  const auto report = gcode_judge_report(*verdict, request->settings);
  fmt::print("{}", command.json ? report.dump(2) + "\n" : gcode_judge_text(*verdict));
  if (!command.slicing.report.empty()) {
    const auto ok = write_file(command.slicing.report, report.dump(2) + "\n");
    if (!ok) return fail(ok.error());
  }
  return verdict->right() ? 0 : 1;
}

}  // namespace

void add_sim_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<SimCommand>();
  CLI::App* sub = app.add_subcommand(
      "sim", "a simulated printer for any host program; or the judge of a G-code file");
  auto* pty = sub->add_option("--pty", command->pty, "where to put the link to its terminal");
  auto* tcp = sub->add_option("--tcp", command->tcp, "port on 127.0.0.1; 0 chooses one")
                  ->check(CLI::Range(0, 65535));
  sub->add_option("--control", command->control,
                  "where to put a Unix socket that takes faults, and the buttons, while it runs");
  sub->add_option("--options", command->options,
                  "as behind 'sim:?': seed=7&corrupt=0.002&baud=115200");
  sub->add_option("--speed", command->speed, "seconds of the printer in one of real time")
      ->check(CLI::Range(0.01, 1000.0));
  sub->add_option("--fault", command->faults,
                  "something that goes wrong, NAME[=VALUE][@WHEN]; the names are below. WHEN is "
                  "SECONDS since power on, FROM-TO or lineN; may be given again")
      ->allow_extra_args(false);
  auto* gcode = sub->add_option("--gcode", command->gcode, "a program to print and to judge");
  auto* against =
      sub->add_option("--against", command->against.path, "the model that it is to print");
  gcode->needs(against)->excludes(pty)->excludes(tcp);
  against->needs(gcode);
  sub->add_flag("--json", command->json, "print the verdict as JSON");
  auto* picture = sub->add_option(
      "--picture", command->picture,
      "draw what was laid over what was wanted, as .png or .svg: the first wrong layer");
  picture->needs(gcode);
  sub->add_option("--picture-layer", command->picture_layer, "draw this layer, from 0")
      ->check(CLI::NonNegativeNumber)
      ->needs(picture);
  sub->add_option("--curves", command->curves,
                  "draw temperatures and speeds over time, as .svg or .png")
      ->needs(gcode);
  command->against.add_to(*sub);
  command->slicing.add_to(*sub);
  sub->footer(
      "Example: slipstick sim --pty /tmp/printer --fault lose-ok=0.02 --fault reset@line200\n"
      "         slipstick sim --gcode part.gcode --against part.lua\n\nFaults:\n" +
      help_on_faults());
  sub->callback([command, &run, pty, tcp, gcode] {
    if (gcode->count() > 0) {
      run = [command] { return run_judge(*command); };
      return;
    }
    if (pty->count() + tcp->count() == 0) throw CLI::RequiredError("--pty, --tcp or --gcode");
    run = [command] { return run_sim(*command); };
  });
}

}  // namespace slipstick
