// `slipstick info MODEL`: what a model is and how it should be sampled.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/image/grid.h"
#include "core/region/feature_size.h"
#include "host/commands/command.h"
#include "host/options.h"

namespace slipstick {
namespace {

struct InfoCommand {
  ModelOptions model;
  std::optional<double> sampling;  // mm, to be judged
  bool json = false;
};

// What is told of a model.
struct ModelFacts {
  const LoadedModel& loaded;
  Box3 bounds;
  FeatureSizes sizes;
};

// A quarter of the common 0.4 mm nozzle resolves what it can print; larger models may be coarser,
// down to half of it. Finer where theorem 1 of the paper asks for it, as far as a lattice goes.
double recommended_sampling(const ModelFacts& facts) {
  constexpr double kFine = 0.1, kCoarse = 0.2, kLarge = 400, kFinest = 0.01, kRound = 1000;
  const Vec3 size = facts.bounds.size();
  const double longest = std::max(size.x, size.y);
  const double usual = longest > kLarge ? kCoarse : kFine;
  const auto limit = facts.sizes.sampling_limit();
  if (!limit || usual < *limit) return usual;
  const double finest =
      std::max(kFinest, std::ceil(longest / SliceGrid::kNodesMax * kRound) / kRound);
  return std::max(finest, (std::ceil(*limit * kRound) - 1) / kRound);
}

// The smaller of feature and gap, by which theorem 1 limits the sampling.
struct Tightest {
  std::string_view what;
  ThinPlace place;
};

std::optional<Tightest> tightest(const FeatureSizes& sizes) {
  const auto& feature = sizes.feature;
  const auto& gap = sizes.gap;
  if (feature && (!gap || feature->mm <= gap->mm)) return Tightest{"feature", *feature};
  if (gap) return Tightest{"gap", *gap};
  return {};
}

bool too_coarse(const FeatureSizes& sizes, double sampling) {
  const auto limit = sizes.sampling_limit();
  return limit && sampling >= *limit;
}

nlohmann::ordered_json to_json(const std::optional<ThinPlace>& place) {
  if (!place) return nullptr;
  return {{"mm", place->mm}, {"at", {place->at.x, place->at.y, place->at.z}}};
}

nlohmann::ordered_json too_coarse_json(const FeatureSizes& sizes, std::optional<double> sampling) {
  if (!sampling || !too_coarse(sizes, *sampling)) return nullptr;
  const auto tight = tightest(sizes);
  nlohmann::ordered_json json = to_json(tight->place);
  json["sampling"] = *sampling;
  json["below"] = *sizes.sampling_limit();
  json["because_of"] = tight->what;
  return json;
}

nlohmann::ordered_json describe(const ModelFacts& facts, std::optional<double> sampling) {
  const Box3& bounds = facts.bounds;
  const Vec3 size = bounds.size();
  return {
      {"model", facts.loaded.name},
      {"kind", facts.loaded.model->kind()},
      {"size_of_representation", facts.loaded.model->size_text()},
      {"bounds",
       {{bounds.low.x, bounds.low.y, bounds.low.z}, {bounds.high.x, bounds.high.y, bounds.high.z}}},
      {"size", {size.x, size.y, size.z}},
      {"smallest_feature", to_json(facts.sizes.feature)},
      {"smallest_gap", to_json(facts.sizes.gap)},
      {"estimated_from", {{"sections", facts.sizes.sections}, {"step", facts.sizes.step}}},
      {"recommended_sampling", recommended_sampling(facts)},
      {"sampling_too_coarse", too_coarse_json(facts.sizes, sampling)},
      {"warning", facts.loaded.warning}};
}

std::string text_of(const std::optional<ThinPlace>& place) {
  if (!place) return "none seen";
  return fmt::format("{:.3g} mm at ({:.2f}, {:.2f}, {:.2f})", place->mm, place->at.x, place->at.y,
                     place->at.z);
}

void print_sizes(const ModelFacts& facts, std::optional<double> sampling) {
  const FeatureSizes& sizes = facts.sizes;
  const double recommended = recommended_sampling(facts);
  fmt::print("smallest feature: {}\nsmallest gap: {}\n", text_of(sizes.feature),
             text_of(sizes.gap));
  fmt::print(
      "  (places from the middle of the bed; estimated from {} sections, nodes {:.2g} mm "
      "apart: what is finer is not seen)\n",
      sizes.sections, sizes.step);
  fmt::print("recommended sampling: {} mm\n", recommended);
  const double judged = sampling.value_or(recommended);
  if (!too_coarse(sizes, judged)) return;
  const auto tight = tightest(sizes);
  fmt::print("sampling {} mm is too coarse: it must be below {:.3g} mm for the {} of {}\n", judged,
             *sizes.sampling_limit(), tight->what, text_of(tight->place));
}

CommandResult run_info(const InfoCommand& command) {
  const auto loaded = command.model.load();
  if (!loaded) return fail(loaded.error());
  const auto placed = place_on_bed(*loaded->model, command.model.placement(), {0, 0});
  if (!placed) return fail(placed.error().within(loaded->name));
  const auto sizes = feature_sizes(*loaded->model, inverse(placed->to_model), placed->bounds);
  if (!sizes) return fail(sizes.error().within(loaded->name));
  const ModelFacts facts{*loaded, placed->bounds, *sizes};
  if (command.json) {
    std::cout << describe(facts, command.sampling).dump(2) << '\n';
    return 0;
  }
  const Vec3 size = placed->bounds.size();
  fmt::print("{}: {}, {}\n", loaded->name, loaded->model->kind(), loaded->model->size_text());
  fmt::print("size: {:.4g} x {:.4g} x {:.4g} mm as placed\n", size.x, size.y, size.z);
  print_sizes(facts, command.sampling);
  if (!loaded->warning.empty()) fmt::print("warning: {}\n", loaded->warning);
  return 0;
}

}  // namespace

void add_info_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<InfoCommand>();
  CLI::App* sub =
      app.add_subcommand("info", "kind, size, thinnest places and recommended sampling of a model");
  sub->add_option("model", command->model.path, "the model")->required();
  command->model.add_to(*sub);
  sub->add_option("--sampling", command->sampling, "mm: say where this sampling is too coarse")
      ->check(CLI::Range(SliceGrid::kWidthMin, SliceGrid::kWidthMax));
  sub->add_flag("--json", command->json, "print as JSON");
  sub->footer("Example: slipstick info bunny.ply --fit 60,60,60");
  sub->callback([command, &run] { run = [command] { return run_info(*command); }; });
}

}  // namespace slipstick
