// `slipstick verify FILE.jsonl [--against MODEL]`: checks contours by code that had no part in
// making them.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "core/image/sample.h"
#include "host/commands/command.h"
#include "host/contours_file.h"
#include "host/options.h"

namespace slipstick {
namespace {

struct VerifyCommand {
  std::string file;
  ModelOptions against;
  bool json = false;
};

struct Found {
  int layers = 0;
  std::size_t loops = 0;
  std::size_t violations = 0;
};

// The solid the contours claim to be of, in their frame, with the samples they must separate.
struct Reference {
  std::shared_ptr<const Solid> solid;
  SliceGrid grid;
};

Result<std::optional<Reference>> reference(const VerifyCommand& command,
                                           const ContoursFile::Header& header) {
  if (command.against.path.empty()) return std::optional<Reference>();
  const auto loaded = command.against.load();
  if (!loaded) return fail(loaded.error());
  const Affine3 map = inverse(header.to_model);
  const Box3 bounds = loaded->model->bounds_under(map);
  const double width = header.grid_width > 0 ? header.grid_width : header.sampling;
  const auto grid =
      SliceGrid::over({{bounds.low.x, bounds.low.y}, {bounds.high.x, bounds.high.y}}, width);
  if (!grid) return fail(grid.error().within(loaded->name));
  return std::optional<Reference>({loaded->model->placed(map), *grid});
}

Result<std::vector<Violation>> check(const ContoursFile::Layer& layer,
                                     const ContoursFile::Header& header,
                                     const std::optional<Reference>& reference) {
  std::vector<Violation> found = audit_loops(layer.loops);
  const auto add = [&found](const std::vector<Violation>& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  if (header.grid_width > 0) add(audit_sticks(layer.loops, header.grid_width));
  if (reference) {
    const auto image = sample(*reference->solid->section(layer.z), reference->grid);
    if (!image) return fail(image.error());
    add(audit_samples(layer.loops, *image));
  }
  return found;
}

void print_violations(const ContoursFile::Layer& layer, const std::vector<Violation>& violations) {
  constexpr std::size_t kShown = 3;
  for (std::size_t i = 0; i < std::min(violations.size(), kShown); ++i) {
    const Violation& v = violations[i];
    fmt::print(stderr, "layer {} z={:.4g}: {} at {:.6g}, {:.6g}\n", layer.index, layer.z,
               describe(v.kind), v.where.x, v.where.y);
  }
}

void print_found(const VerifyCommand& command, const Found& found) {
  if (command.json) {
    const nlohmann::ordered_json json{
        {"layers", found.layers}, {"loops", found.loops}, {"violations", found.violations}};
    std::cout << json.dump() << '\n';
  } else {
    fmt::print("{} layers, {} loops, {} violations\n", found.layers, found.loops, found.violations);
  }
}

CommandResult run_verify(const VerifyCommand& command) {
  auto file = ContoursFile::open(command.file);
  if (!file) return fail(file.error());
  const auto against = reference(command, file->header());
  if (!against) return fail(against.error());
  Found found;
  while (true) {
    const auto layer = file->next();
    if (!layer) return fail(layer.error());
    if (!*layer) break;
    const auto violations = check(**layer, file->header(), *against);
    if (!violations) return fail(violations.error());
    print_violations(**layer, *violations);
    ++found.layers;
    found.loops += (*layer)->loops.size();
    found.violations += violations->size();
  }
  print_found(command, found);
  return found.violations == 0 ? 0 : 1;
}

}  // namespace

void add_verify_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<VerifyCommand>();
  CLI::App* sub = app.add_subcommand("verify", "check contours independently of what made them");
  sub->add_option("file", command->file, "contours, .jsonl")->required();
  sub->add_option("--against", command->against.path, "the model: its samples must be separated");
  command->against.add_loading_to(*sub);
  sub->add_flag("--json", command->json, "print the result as JSON");
  sub->footer("Example: slipstick verify sphere.jsonl --against configs/solids/gyroid_sphere.lua");
  sub->callback([command, &run] { run = [command] { return run_verify(*command); }; });
}

}  // namespace slipstick
