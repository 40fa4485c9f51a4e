// `slipstick print MODEL_OR_GCODE --port PORT`: slices just in time and streams.
// `slipstick print --resume JOURNAL`: takes up a print that was cut off.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <functional>
#include <iostream>

#include "host/atomic_file.h"
#include "host/commands/command.h"
#include "host/file_lines.h"
#include "host/interrupt.h"
#include "host/journalled_print.h"
#include "host/layer_lines.h"
#include "host/options.h"
#include "host/pause.h"
#include "host/print_watch.h"
#include "host/printer_link.h"
#include "host/progress.h"
#include "host/reconnect.h"
#include "host/report.h"
#include "host/stopwatch.h"

namespace slipstick {
namespace {

struct PrintCommand {
  ModelOptions model;
  SlicingOptions slicing;
  std::string port;
  std::string journal;
  std::string resume;
  bool recover = false;
  bool json = false;
  std::vector<std::string> words;

  void add_to(CLI::App& sub) {
    sub.add_option("model", model.path, "a model, or a .gcode file");
    sub.add_option("--port", port,
                   "/dev/ttyUSB0, usb:VID:PID[:SERIAL], pty:PATH, tcp:HOST:PORT or sim:");
    sub.add_option("--journal", journal, "file to keep, from which the print can be taken up");
    sub.add_option("--resume", resume, "journal of a print that was cut off: go on with it");
    sub.add_flag("--recover", recover,
                 "with --resume, where the printer was reset: heat, lift, home X and Y, go on");
    sub.add_flag("--json", json, "print the report on standard output");
    model.add_to(sub);
    slicing.add_to(sub);
  }
};

// How long a simulated machine may take to finish what it was sent.
constexpr std::chrono::hours kRunDownMax{1};

bool is_gcode(const std::filesystem::path& path) {
  return path.extension() == ".gcode" || path.extension() == ".g" || path.extension() == ".gco";
}

nlohmann::ordered_json printer_report(const StreamOutcome& outcome, int reconnects) {
  return {{"firmware", outcome.firmware},
          {"lines_sent", outcome.counters.lines_sent},
          {"lines_acknowledged", outcome.counters.lines_acknowledged},
          {"resends", outcome.counters.resends},
          {"reconnects", reconnects},
          {"starved_seconds", outcome.starved_seconds},
          {"not_done", outcome.not_done},
          {"unknown_commands", outcome.unknown_commands}};
}

nlohmann::ordered_json sim_report(const SimTransport& sim, PrintWatch& watch) {
  const PrintVerdict& verdict = watch.finish();
  const PrinterStatistics statistics = sim.printer().statistics();
  return {{"print_seconds", std::chrono::duration<double>(sim.clock().now()).count()},
          {"filament_mm", watch.filament_mm()},
          {"underruns", statistics.motion.starvations},
          {"bytes_damaged", statistics.bytes_damaged},
          {"deposit",
           {{"layers", verdict.layers},
            {"components_wrong", verdict.components_wrong},
            {"holes_wrong", verdict.holes_wrong},
            {"area_error", verdict.area_error_max},
            {"wrong_at", verdict.wrong_at}}}};
}

class PrintRun {
 public:
  PrintRun(const PrintCommand& command, ReturningPort& port, JournalledPrint& journal)
      : command_(command), port_(port), journal_(journal) {}

  CommandResult run() {
    auto request = command_.slicing.request(SliceGoal::kToolpaths);
    if (!request) return fail(request.error());
    request_ = std::move(*request);
    const std::filesystem::path path = command_.model.path;
    if (const auto ok = journal_.identify(path, request_.settings); !ok) return fail(ok.error());
    watch_.emplace(request_.settings.printer.filament_diameter, request_.settings.slicing.sampling);
    const auto done = is_gcode(path) ? print_file(path) : print_model();
    if (!done) return fail(done.error());
    if (const auto ok = write_report(); !ok) return fail(ok.error());
    return exit_status();
  }

 private:
  Result<void> print_file(const std::filesystem::path& path) {
    if (const auto count = FileLines::check(path); !count) return fail(count.error());
    auto lines = FileLines::open(path);
    if (!lines) return fail(lines.error());
    report_["model"] = path.filename().string();
    if (const auto ok = connect(); !ok) return ok;
    return stream(**lines);
  }

  Result<void> print_model() {
    const auto loaded = command_.model.load();
    if (!loaded) return fail(loaded.error());
    if (!loaded->warning.empty()) spdlog::warn("{}: {}", loaded->name, loaded->warning);
    const PrinterSettings& printer = request_.settings.printer;
    const auto placed =
        place_on_bed(*loaded->model, command_.model.placement(), bed_centre(printer));
    if (!placed) return fail(placed.error().within(loaded->name));
    if (const auto fits = check_build_volume(placed->bounds, printer); !fits) {
      return fail(fits.error().within(loaded->name));
    }
    const double load_seconds = Stopwatch(total_).lap();
    request_.timeline = std::make_shared<SettingsTimeline>(request_.settings);
    if (const auto ok = journal_.keep(request_.timeline); !ok) return ok;
    if (journal_.resumes()) {
      if (const auto ok = connect(); !ok) return ok;
    }
    if (const auto& layer = journal_.first_layer()) request_.first_layer = layer->layer;
    auto job = SlicingJob::start(*placed, request_);
    if (!job) return fail(job.error().within(loaded->name));
    if (const auto ok = stream_layers(**job); !ok) return ok;
    report_ = slicing_report(**job, request_.settings,
                             {loaded->name, std::string(loaded->model->kind()), load_seconds,
                              Stopwatch(total_).lap(), first_extrusion_});
    violations_ = (*job)->totals().violations;
    return {};
  }

  Result<void> stream_layers(SlicingJob& job) {
    Progress progress("printing", job.end_layer() - job.first_layer());
    bool extruded = false;
    const auto on_layer = [&](const SlicedLayer& layer) {
      watch_->expect(layer);
      journal_.began(layer.index, layer.program->text);
      extruded |= !layer.toolpaths->beads.empty();
      if (extruded && first_extrusion_ == 0) first_extrusion_ = Stopwatch(total_).lap();
      progress.show(job.totals().layers, layer.top);
    };
    const auto beginning =
        journal_.first_layer() ? LayerLines::Beginning::kLayer : LayerLines::Beginning::kStart;
    LayerLines lines(job, request_.settings, on_layer, beginning);
    if (!link_) {
      if (const auto ok = connect(); !ok) return ok;
    }
    if (const auto ok = stream(lines); !ok) return ok;
    if (extruded || journal_.resumes()) return {};
    return fail(ErrorCode::kInput, "nothing was printed: no sample of any layer is inside");
  }

  Result<void> connect() {
    auto link = open_printer(port_.address(), request_.settings.printer, watch_->sink());
    if (!link) return fail(port_.met(link.error()));
    link_ = std::move(*link);
    const auto found = journal_.find(*link_->transport, *link_->clock);
    if (!found) return fail(port_.met(found.error()));
    return {};
  }

  Result<void> stream(LineSource& source) {
    StreamOptions options{.pace = link_->pace, .parking = parking_place(request_.settings)};
    const auto lines = journal_.begin(source, *link_->clock, options);
    if (!lines) return fail(lines.error());
    options.sender.window = request_.settings.printer.window;
    Interrupt::pause_by_terminal();
    const auto outcome = stream_job(*link_->transport, *link_->clock, **lines, options);
    journal_.ended(outcome);
    if (!outcome) return fail(outcome.error());
    outcome_ = *outcome;
    if (link_->sim == nullptr) return {};
    link_->sim->run_down(kRunDownMax);
    sim_report_ = sim_report(*link_->sim, *watch_);
    return {};
  }

  Result<void> write_report() {
    report_["printer"] = printer_report(outcome_, port_.returns());
    if (!sim_report_.is_null()) report_["sim"] = sim_report_;
    // A printer may call itself by bytes that are no text.
    const std::string report =
        report_.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (command_.json) std::cout << report;
    if (!command_.json) summary();
    if (command_.slicing.report.empty()) return {};
    return write_file(command_.slicing.report, report);
  }

  void summary() const {
    fmt::print("printed {} lines, {} sent again\n", outcome_.counters.lines_acknowledged,
               outcome_.counters.resends);
    if (sim_report_.is_null()) return;
    const PrintVerdict& v = watch_->verdict();
    fmt::print("{} layers judged: {} wrong components, {} wrong holes; {} contour violations\n",
               v.layers, v.components_wrong, v.holes_wrong, violations_);
  }

  // A print that came out wrong is a failed job, if it was sliced from a model.
  int exit_status() const {
    const PrintVerdict& v = watch_->verdict();
    return violations_ == 0 && v.components_wrong == 0 && v.holes_wrong == 0 ? 0 : 1;
  }

  const PrintCommand& command_;
  ReturningPort& port_;
  JournalledPrint& journal_;
  Stopwatch total_;
  SlicingRequest request_;
  std::optional<PrintWatch> watch_;
  std::optional<PrinterLink> link_;
  StreamOutcome outcome_;
  double first_extrusion_ = 0;
  std::size_t violations_ = 0;
  nlohmann::ordered_json report_;
  nlohmann::ordered_json sim_report_;
};

// The command line that a journal tells.
Result<std::shared_ptr<PrintCommand>> command_of(const JournalHeader& header) {
  if (header.words.empty()) {
    return fail(ErrorCode::kInput, "a daemon keeps this journal; take the print up on its page");
  }
  const auto command = std::make_shared<PrintCommand>();
  CLI::App app("", "slipstick");
  app.fallthrough();
  std::string ignored;
  app.add_option("--log-level", ignored);
  command->add_to(*app.add_subcommand("print"));
  try {
    app.parse(std::vector<std::string>(header.words.rbegin(), header.words.rend()));
  } catch (const CLI::ParseError& error) {
    return fail(ErrorCode::kInput,
                std::string("the journal's command line is not understood: ") + error.what());
  }
  return command;
}

// The journal at `path` is `first()`, or what it says when the port is back.
CommandResult run_through_gaps(const PrintCommand& command, const std::filesystem::path& path,
                               const std::function<JournalledPrint()>& first) {
  const auto address = parse_transport_address(command.port);
  if (!address) return fail(address.error());
  ReturningPort port(
      *address, {[](const std::string& text) { spdlog::warn("{}", text); }, &Interrupt::requested});
  return print_through_gaps(port, path, [&](std::optional<JournalContent> rest) {
    JournalledPrint journal =
        rest ? JournalledPrint(path, *std::move(rest), Consent::kNone) : first();
    return PrintRun(command, port, journal).run();
  });
}

CommandResult run_resumed(const PrintCommand& command) {
  const std::filesystem::path path = std::filesystem::absolute(command.resume);
  auto content = read_journal(path);
  if (!content) return fail(content.error());
  const auto original = command_of(content->header);
  if (!original) return fail(original.error().within(path.string()));
  if (!command.port.empty()) (*original)->port = command.port;
  if (!command.slicing.report.empty())
    (*original)->slicing.report = std::filesystem::absolute(command.slicing.report);
  (*original)->json = command.json;
  std::error_code error;
  std::filesystem::current_path(content->header.folder, error);
  if (error) {
    return fail(ErrorCode::kInput, fmt::format("{}: the print began in {}: {}", path.string(),
                                               content->header.folder, error.message()));
  }
  const Consent consent = command.recover ? Consent::kRecover : Consent::kNone;
  return run_through_gaps(**original, path,
                          [&] { return JournalledPrint(path, *content, consent); });
}

CommandResult run_print(const PrintCommand& command) {
  if (!command.resume.empty()) return run_resumed(command);
  if (command.journal.empty()) {
    return run_through_gaps(command, {}, [] { return JournalledPrint(); });
  }
  const std::string folder = std::filesystem::current_path().string();
  return run_through_gaps(command, command.journal, [&] {
    return JournalledPrint(command.journal, JournalHeader{folder, command.words, 0, 0});
  });
}

void check_usage(const PrintCommand& command) {
  if (command.resume.empty() && command.model.path.empty()) throw CLI::RequiredError("model");
  if (command.resume.empty() && command.port.empty()) throw CLI::RequiredError("--port");
  if (command.recover && command.resume.empty()) throw CLI::RequiredError("--resume");
  if (!command.resume.empty() && !(command.model.path.empty() && command.journal.empty()))
    throw CLI::ExcludesError("--resume", "a model and --journal, which the journal tells");
}

}  // namespace

void add_print_command(CLI::App& app, ChosenCommand& run, const std::vector<std::string>& words) {
  const auto command = std::make_shared<PrintCommand>();
  command->words = words;
  CLI::App* sub = app.add_subcommand("print", "slice a model just in time and print it");
  command->add_to(*sub);
  sub->footer(
      "Example: slipstick print configs/solids/gyroid_sphere.lua --port sim:\n"
      "         slipstick print --resume ball.journal\n"
      "Ctrl-Z pauses with the nozzle parked and hot, and goes on; Ctrl-C ends with heaters off.");
  sub->callback([command, &run] {
    check_usage(*command);
    run = [command] { return run_print(*command); };
  });
}

}  // namespace slipstick
