#include "host/serve/print_task.h"

#include <nlohmann/json.hpp>

#include "host/file_lines.h"
#include "host/journalled_print.h"
#include "host/layer_lines.h"
#include "host/pause.h"
#include "host/print_watch.h"
#include "host/printer_link.h"
#include "host/reconnect.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

// How long a simulated machine may take to finish what it was sent.
constexpr std::chrono::hours kRunDownMax{1};

// Counts what is taken from another source.
class CountedLines final : public LineSource {
 public:
  using OnLine = std::function<void(std::int64_t)>;
  CountedLines(LineSource& source, OnLine on_line)
      : source_(source), on_line_(std::move(on_line)) {}

  Result<std::optional<Line>> next() override {
    on_line_(++count_);
    return source_.next();
  }
  bool ready() const override { return source_.ready(); }
  bool take_pause() override { return source_.take_pause(); }

 private:
  LineSource& source_;
  const OnLine on_line_;
  std::int64_t count_ = 0;
};

Json sim_json(const PrintVerdict& verdict) {
  return {{"layers", verdict.layers},
          {"components_wrong", verdict.components_wrong},
          {"holes_wrong", verdict.holes_wrong}};
}

class TaskRun {
 public:
  TaskRun(const PrintTask& task, ReturningPort& port, JournalledPrint& journal,
          PrintControl& control, const TaskListeners& listeners)
      : task_(task), port_(port), journal_(journal), control_(control), listeners_(listeners) {}

  Result<std::string> run() {
    const auto settings = load_settings(task_.spec.settings);
    if (!settings) return fail(settings.error());
    if (const auto ok = journal_.identify(task_.path, *settings); !ok) return fail(ok.error());
    watch_.emplace(settings->printer.filament_diameter, settings->slicing.sampling);
    const auto done = task_.is_gcode ? print_file(*settings) : print_model();
    if (!done) return fail(done.error());
    return report_.dump();
  }

 private:
  Result<void> print_file(const PrintSettings& settings) {
    const auto count = FileLines::check(task_.path);
    if (!count) return fail(count.error().within(task_.name));
    const auto file = FileLines::open(task_.path);
    if (!file) return fail(file.error());
    listeners_.on_start(0);
    const double total = double(std::max<std::int64_t>(*count, 1));
    CountedLines lines(**file, [&](std::int64_t line) {
      listeners_.on_completion(std::min(double(line - 1) / total, 1.0));
    });
    if (const auto ok = connect(settings.printer); !ok) return ok;
    return stream(lines, settings);
  }

  Result<void> print_model() {
    const auto prepared = prepare_model(task_.path, task_.name, task_.spec, SliceGoal::kToolpaths);
    if (!prepared) return fail(prepared.error());
    SlicingRequest request = prepared->request;
    request.timeline =
        task_.timeline ? task_.timeline : std::make_shared<SettingsTimeline>(request.settings);
    if (const auto ok = journal_.keep(request.timeline); !ok) return ok;
    if (journal_.resumes()) {
      if (const auto ok = connect(request.settings.printer); !ok) return ok;
    }
    const auto& cut_off = journal_.first_layer();
    if (cut_off) request.first_layer = cut_off->layer;
    auto job = SlicingJob::start(prepared->placed, request);
    if (!job) return fail(job.error().within(task_.name));
    const int first = prepared->request.first_layer;
    listeners_.on_start((*job)->end_layer() - first);
    const auto on_layer = [&](const SlicedLayer& layer) {
      watch_->expect(layer);
      const std::string& program = layer.program->text;
      journal_.began(layer.index, program);
      layer_ = PrintedLayer{layer.index - first + 1, layer.top, line_ - 1,
                            lines_of_layer(program), program,   layer.image};
      if (let_by_) tell_layer();
    };
    LayerLines layers(**job, request.settings, on_layer,
                      cut_off ? LayerLines::Beginning::kLayer : LayerLines::Beginning::kStart);
    layers.pause_before(listeners_.pause_before);
    CountedLines lines(layers, [this](std::int64_t line) { line_ = line; });
    if (!link_) {
      if (const auto ok = connect(request.settings.printer); !ok) return ok;
    }
    if (const auto ok = stream(lines, request.settings); !ok) return ok;
    report_["layers"] = (*job)->totals().layers;
    report_["violations"] = (*job)->totals().violations;
    report_["filament_mm"] = (*job)->totals().filament_mm;
    return {};
  }

  Result<void> connect(const PrinterSettings& printer) {
    if (control_.wish() >= PrintControl::Wish::kCancel)
      return fail(ErrorCode::kCancelled, "cancelled before it was sent anything");
    auto link = open_printer(port_.address(), printer, watch_->sink());
    if (!link) return fail(port_.met(link.error()));
    link_ = std::move(*link);
    if (task_.serial_log) {
      link_->transport =
          std::make_unique<LoggedTransport>(std::move(link_->transport), *task_.serial_log);
    }
    const auto found = journal_.find(*link_->transport, *link_->clock);
    if (!found) return fail(port_.met(found.error()));
    return {};
  }

  // Lines that were let go by, as they were printed before, are not of this stream.
  void tell_layer() {
    if (!layer_) return;
    layer_->lines_before -= *let_by_;
    listeners_.on_layer(*std::exchange(layer_, std::nullopt));
  }

  Result<void> stream(LineSource& source, const PrintSettings& settings) {
    StreamOptions options{link_->pace, parking_place(settings)};
    const auto lines = journal_.begin(source, *link_->clock, options);
    if (!lines) return fail(lines.error());
    let_by_ = line_;
    tell_layer();
    options.sender.window = settings.printer.window;
    const auto outcome = stream_job(*link_->transport, *link_->clock, **lines, options, control_);
    journal_.ended(outcome);
    if (!outcome) return fail(outcome.error());
    report_["lines"] = outcome->counters.lines_acknowledged;
    report_["resends"] = outcome->counters.resends;
    report_["starved_seconds"] = outcome->starved_seconds;
    report_["turnaround_p50"] = outcome->turnaround.seconds_within(0.5);
    report_["turnaround_p99"] = outcome->turnaround.seconds_within(0.99);
    report_["seconds"] = outcome->seconds;
    if (link_->sim == nullptr) return {};
    link_->sim->run_down(kRunDownMax);
    report_["sim"] = sim_json(watch_->finish());
    return {};
  }

  const PrintTask& task_;
  ReturningPort& port_;
  JournalledPrint& journal_;
  PrintControl& control_;
  const TaskListeners& listeners_;
  std::optional<PrintWatch> watch_;
  std::optional<PrinterLink> link_;
  std::int64_t line_ = 0;                ///< Of the model's program, last taken.
  std::optional<std::int64_t> let_by_;   ///< Of these, before the stream began; none: it has not.
  std::optional<PrintedLayer> layer_{};  ///< Not told yet.
  Json report_;
};

}  // namespace

Result<std::string> run_print_task(const PrintTask& task, PrintControl& control,
                                   const TaskListeners& listeners) {
  const auto address = parse_transport_address(task.port);
  if (!address) return fail(address.error());
  const bool kept = address->kind != TransportKind::kSim;
  ReturningPort port(*address, {[&](const std::string& text) { control.tell(MessageSeen{text}); },
                                [&] { return control.wish() >= PrintControl::Wish::kCancel; }});
  const auto run = [&](JournalledPrint journal) {
    return TaskRun(task, port, journal, control, listeners).run();
  };
  return print_through_gaps(
      port, kept ? task.journal : "",
      [&](std::optional<JournalContent> rest) -> Result<std::string> {
        if (rest) return run({task.journal, *std::move(rest), Consent::kNone});
        if (!task.take_up) return run(kept ? JournalledPrint(task.journal, {}) : JournalledPrint());
        auto content = read_journal(task.journal);
        if (!content) return fail(content.error());
        return run({task.journal, *std::move(content), *task.take_up});
      });
}

}  // namespace slipstick
