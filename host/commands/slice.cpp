// `slipstick slice MODEL -o OUT`: direct slicing into files.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <iostream>

#include "host/atomic_file.h"
#include "host/commands/command.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/outputs/contours_sink.h"
#include "host/outputs/gcode_sink.h"
#include "host/outputs/picture_sink.h"
#include "host/progress.h"
#include "host/report.h"
#include "host/stopwatch.h"

namespace slipstick {
namespace {

struct SliceCommand {
  ModelOptions model;
  SlicingOptions slicing;
  std::vector<std::string> outputs;
  bool split = false;
  bool json = false;
};

bool wants_toolpaths(const std::filesystem::path& path) {
  return path == "-" || path.extension() != ".jsonl";
}

Result<std::unique_ptr<LayerSink>> make_sink(const std::filesystem::path& path, bool split,
                                             const SinkContext& context) {
  if (path == "-" || path.extension() == ".gcode") return make_gcode_sink(path, context);
  if (path.extension() == ".jsonl") return make_contours_sink(path, context);
  if (path.extension() == ".svg" || path.extension() == ".png") {
    return make_picture_sink(path, split ? PictureLayout::kFolder : PictureLayout::kSheet, context);
  }
  return fail(ErrorCode::kInput,
              fmt::format("{}: outputs are .gcode, .jsonl, .svg, .png or - for G-code on standard "
                          "output",
                          path.string()));
}

using Sinks = std::vector<std::unique_ptr<LayerSink>>;

Result<Sinks> make_sinks(const SliceCommand& command, const SinkContext& context) {
  Sinks sinks;
  for (const std::string& output : command.outputs) {
    auto sink = make_sink(output, command.split, context);
    if (!sink) return fail(sink.error());
    sinks.push_back(std::move(*sink));
  }
  return sinks;
}

bool extrudes(const SlicedLayer& layer) {
  return layer.toolpaths && !layer.toolpaths->beads.empty();
}

// Seconds until the first extruding line was handed on.
Result<double> run_job(SlicingJob& job, const Sinks& sinks, Stopwatch total) {
  Progress progress("slicing", job.end_layer() - job.first_layer());
  std::optional<double> first_extrusion;
  while (true) {
    if (Interrupt::requested())
      return fail(ErrorCode::kCancelled, "interrupted; nothing was written");
    auto layer = job.next();
    if (!layer) return fail(layer.error());
    if (!*layer) break;
    for (const auto& sink : sinks) {
      if (const auto ok = sink->add(**layer); !ok) return fail(ok.error());
    }
    if (!first_extrusion && extrudes(**layer)) first_extrusion = Stopwatch(total).lap();
    progress.show(job.totals().layers, (*layer)->top);
  }
  if (job.totals().edges_after == 0) {
    return fail(
        ErrorCode::kInput,
        "nothing to print: no sample of any layer is inside; is --sampling finer than the model's "
        "features?");
  }
  for (const auto& sink : sinks) {
    if (const auto ok = sink->finish(); !ok) return fail(ok.error());
  }
  return first_extrusion.value_or(0);
}

Result<PlacedSolid> placed_on(const Model& model, const PlacementRequest& request,
                              const PrinterSettings& printer) {
  return place_on_bed(model, request, bed_centre(printer));
}

CommandResult run_slice(const SliceCommand& command) {
  Stopwatch total;
  const bool toolpaths =
      std::any_of(command.outputs.begin(), command.outputs.end(), wants_toolpaths);
  const auto request =
      command.slicing.request(toolpaths ? SliceGoal::kToolpaths : SliceGoal::kContours);
  if (!request) return fail(request.error());
  const auto loaded = command.model.load();
  if (!loaded) return fail(loaded.error());
  if (!loaded->warning.empty()) spdlog::warn("{}: {}", loaded->name, loaded->warning);
  const auto placed =
      placed_on(*loaded->model, command.model.placement(), request->settings.printer);
  if (!placed) return fail(placed.error().within(loaded->name));
  if (toolpaths) {
    const auto fits = check_build_volume(placed->bounds, request->settings.printer);
    if (!fits) return fail(fits.error().within(loaded->name));
  }
  const double load_seconds = Stopwatch(total).lap();
  auto job = SlicingJob::start(*placed, *request);
  if (!job) return fail(job.error().within(loaded->name));
  const SinkContext context{loaded->name, &request->settings, job->get(), placed->to_model};
  const auto sinks = make_sinks(command, context);
  if (!sinks) return fail(sinks.error());
  const auto first_extrusion = run_job(**job, *sinks, total);
  if (!first_extrusion) return fail(first_extrusion.error());
  const auto report = slicing_report(**job, request->settings,
                                     {loaded->name, std::string(loaded->model->kind()),
                                      load_seconds, Stopwatch(total).lap(), *first_extrusion});
  if (command.json) std::cout << report.dump(2) << '\n';
  if (!command.slicing.report.empty()) {
    const auto ok = write_file(command.slicing.report, report.dump(2) + "\n");
    if (!ok) return fail(ok.error());
  }
  return (*job)->totals().violations == 0 ? 0 : 1;
}

}  // namespace

void add_slice_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<SliceCommand>();
  CLI::App* sub = app.add_subcommand("slice", "slice a model into G-code, contours or pictures");
  sub->add_option("model", command->model.path,
                  "the model: .lua .vm .ldni .lda .bsp .rbf .stl .obj .ply .off .3mf .xyz .pwn")
      ->required();
  sub->add_option("-o,--output", command->outputs,
                  "FILE.gcode, .jsonl, .svg, .png, or - for G-code on standard output; repeatable")
      ->required();
  sub->add_flag("--split", command->split, "pictures: a folder with one for each layer");
  sub->add_flag("--json", command->json, "print the report on standard output");
  command->model.add_to(*sub);
  command->slicing.add_to(*sub);
  sub->footer("Example: slipstick slice configs/solids/gyroid_sphere.lua -o sphere.gcode");
  sub->callback([command, &run] { run = [command] { return run_slice(*command); }; });
}

}  // namespace slipstick
