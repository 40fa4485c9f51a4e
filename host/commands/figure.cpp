// `slipstick figure KIND MODEL -o OUT`: the paper's figures of any model.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>

#include "host/atomic_file.h"
#include "host/commands/command.h"
#include "host/figures/image_figure.h"
#include "host/figures/segments_figure.h"
#include "host/figures/stack_figure.h"
#include "host/figures/stages_figure.h"
#include "host/options.h"

namespace slipstick {
namespace {

struct FigureCommand {
  std::string kind;
  ModelOptions model;
  SlicingOptions slicing;
  LayerChoice layer;
  std::vector<double> window;
  int side = 1000;
  std::string output;
};

Result<std::optional<Box2>> window_of(const std::vector<double>& w) {
  if (w.empty()) return std::optional<Box2>();
  if (w[0] < w[2] && w[1] < w[3]) return std::optional(Box2{{w[0], w[1]}, {w[2], w[3]}});
  return fail(ErrorCode::kInput, "--window wants X0<X1 and Y0<Y1");
}

// Each kind shows one layer or all of them; options of the others would mean nothing.
Result<void> check_options(const FigureCommand& command) {
  const bool one = command.layer.index || command.layer.height || !command.window.empty();
  if (command.kind == "stack" && one) {
    return fail(
        ErrorCode::kInput,
        "figure stack shows all layers: leave out --layer, --height and --window, or choose "
        "some by --layers A:B");
  }
  if (command.kind != "stack" && !command.slicing.layers.empty()) {
    return fail(ErrorCode::kInput, fmt::format("figure {} shows one layer: give --layer N instead "
                                               "of --layers",
                                               command.kind));
  }
  return {};
}

// Before anything is sampled.
Result<void> check_output(const std::filesystem::path& path) {
  if (path.extension() != ".svg" && path.extension() != ".png") return fail(no_picture(path));
  if (const auto probe = AtomicFile::create(path); !probe) return fail(probe.error());
  return {};
}

Result<void> draw_all(const FigureCommand& command, const PlacedSolid& placed,
                      const SlicingRequest& request) {
  auto job = SlicingJob::start(placed, request);
  if (!job) return fail(job.error());
  return draw_stack(**job, command.side, command.output);
}

Result<void> draw_one(const FigureCommand& command, const PlacedSolid& placed,
                      const SlicingRequest& request) {
  const auto window = window_of(command.window);
  if (!window) return fail(window.error());
  const auto layer = figure_layer(placed, request, command.layer);
  if (!layer) return fail(layer.error());
  const SlicingSettings& slicing = request.settings.slicing;
  if (command.kind == "image") return draw_image(*layer, *window, command.output);
  if (command.kind == "stages") {
    return draw_stages(placed, *layer, slicing.ambiguity, *window, command.output);
  }
  return draw_segments(*layer, segmentation_of(placed, *layer, slicing), *window, command.output);
}

CommandResult run_figure(const FigureCommand& command) {
  if (const auto ok = check_options(command); !ok) return fail(ok.error());
  if (const auto ok = check_output(command.output); !ok) return fail(ok.error());
  auto request = command.slicing.request(SliceGoal::kContours);
  if (!request) return fail(request.error());
  request->settings.slicing.certify = Certification::kOff;
  const auto loaded = command.model.load();
  if (!loaded) return fail(loaded.error());
  if (!loaded->warning.empty()) spdlog::warn("{}: {}", loaded->name, loaded->warning);
  const auto placed = place_on_bed(*loaded->model, command.model.placement(),
                                   bed_centre(request->settings.printer));
  if (!placed) return fail(placed.error().within(loaded->name));
  const auto drawn = command.kind == "stack" ? draw_all(command, *placed, *request)
                                             : draw_one(command, *placed, *request);
  if (!drawn) return fail(drawn.error().within(loaded->name));
  return 0;
}

constexpr const char* kFigureHelp =
    "image     the samples of one layer, inside ones dark (figs. 5, 6)\n"
    "stages    a window of one layer: midpoints, sliding, projection, Laplacian, roots (fig. 10)\n"
    "segments  the clustering of one layer's contours, and what is left of them (fig. 12)\n"
    "stack     the contours of all layers, seen obliquely (figs. 15 d, 21 b, 22 b)\n"
    "Example: slipstick figure stages configs/solids/gyroid_sphere.lua --layer 60 -o stages.svg";

}  // namespace

void add_figure_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<FigureCommand>();
  CLI::App* sub = app.add_subcommand("figure", "the paper's figures of a model");
  sub->add_option("kind", command->kind, "image, stages, segments or stack")
      ->required()
      ->check(CLI::IsMember({"image", "stages", "segments", "stack"}));
  sub->add_option("model", command->model.path, "the model")->required();
  sub->add_option("-o,--output", command->output, "FILE.svg or FILE.png")->required();
  auto* layer = sub->add_option("--layer", command->layer.index,
                                "which layer, from 0; without it the one halfway up");
  sub->add_option("--height", command->layer.height, "the layer at this height above the bed, mm")
      ->excludes(layer);
  add_numbers_option(*sub, "--window", command->window, 4,
                     "what to show of the layer, mm on the bed: X0,Y0,X1,Y1");
  sub->add_option("--side", command->side, "of a stack: the longest side of the picture, pixels")
      ->check(CLI::Range(100, 8000))
      ->capture_default_str();
  command->model.add_to(*sub);
  command->slicing.add_to(*sub);
  for (const char* meaningless : {"--report", "--certify", "--infill"}) {
    sub->remove_option(sub->get_option(meaningless));
  }
  sub->footer(kFigureHelp);
  sub->callback([command, &run] { run = [command] { return run_figure(*command); }; });
}

}  // namespace slipstick
