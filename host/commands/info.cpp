// `slipstick info MODEL`: what a model is and how it should be sampled.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/commands/command.h"
#include "host/options.h"

namespace slipstick {
namespace {

struct InfoCommand {
  ModelOptions model;
  bool json = false;
};

// A quarter of the common 0.4 mm nozzle resolves what it can print; larger models may be coarser,
// down to half of it.
double recommended_sampling(const Vec3& size) {
  constexpr double kFine = 0.1, kCoarse = 0.2, kLarge = 400;
  return std::max(size.x, size.y) > kLarge ? kCoarse : kFine;
}

nlohmann::ordered_json describe(const LoadedModel& loaded, const Box3& bounds) {
  const Vec3 size = bounds.size();
  return {
      {"model", loaded.name},
      {"kind", loaded.model->kind()},
      {"size_of_representation", loaded.model->size_text()},
      {"bounds",
       {{bounds.low.x, bounds.low.y, bounds.low.z}, {bounds.high.x, bounds.high.y, bounds.high.z}}},
      {"size", {size.x, size.y, size.z}},
      {"recommended_sampling", recommended_sampling(size)},
      {"warning", loaded.warning}};
}

CommandResult run_info(const InfoCommand& command) {
  const auto loaded = command.model.load();
  if (!loaded) return fail(loaded.error());
  const auto placed = place_on_bed(*loaded->model, command.model.placement(), {0, 0});
  if (!placed) return fail(placed.error().within(loaded->name));
  const auto json = describe(*loaded, placed->bounds);
  if (command.json) {
    std::cout << json.dump(2) << '\n';
    return 0;
  }
  const Vec3 size = placed->bounds.size();
  fmt::print("{}: {}, {}\n", loaded->name, loaded->model->kind(), loaded->model->size_text());
  fmt::print("size: {:.4g} x {:.4g} x {:.4g} mm as placed\n", size.x, size.y, size.z);
  fmt::print("recommended sampling: {} mm\n", recommended_sampling(size));
  if (!loaded->warning.empty()) fmt::print("warning: {}\n", loaded->warning);
  return 0;
}

}  // namespace

void add_info_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<InfoCommand>();
  CLI::App* sub = app.add_subcommand("info", "kind, size and recommended sampling of a model");
  sub->add_option("model", command->model.path, "the model")->required();
  command->model.add_to(*sub);
  sub->add_flag("--json", command->json, "print as JSON");
  sub->footer("Example: slipstick info bunny.ply --fit 60,60,60");
  sub->callback([command, &run] { run = [command] { return run_info(*command); }; });
}

}  // namespace slipstick
