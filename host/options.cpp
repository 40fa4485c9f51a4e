#include "host/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "core/base/number_text.h"
#include "core/solid/ldni.h"
#include "host/config.h"

namespace slipstick {
namespace {

constexpr double kMillimetresAnInch = 25.4;

Vec3 vec3(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

struct Shorthand {
  const char* option;
  const char* key;
  const char* help;
};

constexpr std::array<Shorthand, 11> kShorthands{{
    {"--layer-height", "layer_height", "mm"},
    {"--first-layer-height", "first_layer_height", "mm"},
    {"--sampling", "sampling", "the paper's r', mm"},
    {"--regularize", "regularize", "open and close the solid by a ball of this radius, mm"},
    {"--alpha", "alpha", "clustering ratio of --simplify vsa"},
    {"--place", "place", "roots, sliding, projection, laplacian or midpoints"},
    {"--simplify", "simplify", "fewest, vsa, greedy or none"},
    {"--tolerance", "tolerance", "mm a simplified contour may be off"},
    {"--ambiguity", "ambiguity", "solid or void: what diagonal samples join"},
    {"--certify", "certify", "strict, report or off: slices that cannot be proved"},
    {"--infill", "infill_density", "0 to 1"},
}};

Result<int> layer_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= 0) return value;
  return fail(
      ErrorCode::kInput,
      fmt::format("--layers wants A:B, the first layer and one past the last, not '{}'", text));
}

Result<void> apply_layers(std::string_view text, SlicingRequest& request) {
  if (text.empty()) return {};
  const std::size_t colon = text.find(':');
  const auto first = colon == 0 ? Result<int>(0) : layer_number(text.substr(0, colon));
  if (!first) return fail(first.error());
  request.first_layer = *first;
  if (colon == std::string_view::npos) {
    request.end_layer = *first + 1;
  } else if (colon + 1 < text.size()) {
    const auto end = layer_number(text.substr(colon + 1));
    if (!end) return fail(end.error());
    request.end_layer = *end;
  }
  return {};
}

}  // namespace

void add_mesh_options(CLI::App& app, LoadOptions& options) {
  app.add_option(
         "--winding", options.winding,
         "of a mesh: nonzero (overlapping shells are one solid) or parity (overlaps are void)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Winding>{
          {"nonzero", Winding::kNonzero}, {"parity", Winding::kParity}}));
  app.add_option("--resolution", options.resolution, "rays a side when a mesh becomes LDNI")
      ->check(CLI::Range(LdniGrid::kResolutionMin, LdniGrid::kResolutionMax))
      ->capture_default_str();
}

CLI::Option* add_numbers_option(CLI::App& app, const std::string& name,
                                std::vector<double>& numbers, std::size_t count,
                                const std::string& help) {
  const auto take = [name, &numbers, count](const std::string& text) {
    numbers.clear();
    for (const std::string& word : CLI::detail::split(text, ',')) {
      const auto number = parse_number(word);
      if (!number) break;
      numbers.push_back(*number);
    }
    const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
    if (numbers.size() == count && commas + 1 == count) return;
    throw CLI::ValidationError(
        name, fmt::format("wants {} numbers with commas between, not '{}'", count, text));
  };
  return app.add_option_function<std::string>(name, take, help)->type_name("NUMBERS");
}

void add_bounds_option(CLI::App& app, std::vector<double>& bounds) {
  add_numbers_option(app, "--bounds", bounds, 6,
                     "extent of a .vm model in its units: X0,Y0,Z0,X1,Y1,Z1");
}

void ModelOptions::add_loading_to(CLI::App& app) {
  app.add_option("--as", loading.as, "what a mesh is sliced as: mesh (exact), ldni or bsp")
      ->transform(CLI::CheckedTransformer(std::map<std::string, MeshAs>{
          {"mesh", MeshAs::kMesh}, {"ldni", MeshAs::kLdni}, {"bsp", MeshAs::kBsp}}));
  add_mesh_options(app, loading);
  add_bounds_option(app, bounds);
}

void ModelOptions::add_to(CLI::App& app) {
  add_loading_to(app);
  app.add_option("--units", units, "of the model: mm or inch")
      ->check(CLI::IsMember({"mm", "inch"}))
      ->capture_default_str();
  app.add_option("--scale", scale, "factor")->capture_default_str();
  add_numbers_option(app, "--fit", fit, 3, "scale evenly to fill X,Y,Z mm");
  add_numbers_option(app, "--rotate", rotate, 3, "degrees about X,Y,Z");
  add_numbers_option(app, "--direction", direction, 3,
                     "slicing direction in the model's frame: X,Y,Z");
}

Result<void> apply_bounds(const std::vector<double>& bounds, LoadOptions& options) {
  if (bounds.empty()) return {};
  options.bounds = {{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
  if (bounds[0] < bounds[3] && bounds[1] < bounds[4] && bounds[2] < bounds[5]) return {};
  return fail(ErrorCode::kInput, "--bounds wants X0<X1, Y0<Y1 and Z0<Z1");
}

Result<LoadedModel> ModelOptions::load() const {
  LoadOptions options = loading;
  if (const auto ok = apply_bounds(bounds, options); !ok) return fail(ok.error());
  return load_model(path, options);
}

PlacementRequest ModelOptions::placement() const {
  PlacementRequest request;
  request.unit = units == "inch" ? kMillimetresAnInch : 1;
  request.scale = scale;
  if (!fit.empty()) request.fit = vec3(fit);
  if (!rotate.empty()) request.rotate = vec3(rotate);
  if (!direction.empty()) request.direction = vec3(direction);
  return request;
}

void SlicingOptions::add_to(CLI::App& app) {
  app.add_option("--printer", printer, "name from configs/printers, or a .toml file")
      ->capture_default_str();
  app.add_option("--material", material, "name from configs/materials, or a .toml file")
      ->capture_default_str();
  app.add_option("--profile", profile, "name from configs/profiles, or a .toml file");
  app.add_option("--set", set, "any setting: key=value, repeatable (docs/SETTINGS.md)")
      ->allow_extra_args(false);
  for (const Shorthand& s : kShorthands) {
    const std::string key = s.key;
    app.add_option_function<std::string>(
        s.option,
        [this, key](const std::string& value) {
          shorthands_.push_back(fmt::format("{}={}", key, value));
        },
        s.help);
  }
  app.add_option("--layers", layers, "only layers A:B, from 0, B not included");
  app.add_option("--threads", threads, "slicing threads; 0 is one a core")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  app.add_option("--report", report, "write what happened to FILE.json");
}

Result<SlicingRequest> SlicingOptions::request(SliceGoal goal) const {
  std::vector<std::string> overrides = shorthands_;
  overrides.insert(overrides.end(), set.begin(), set.end());
  auto settings = load_settings({printer, material, profile, overrides, {}});
  if (!settings) return fail(settings.error());
  SlicingRequest request{std::move(*settings), goal, threads, 0, {}, {}};
  if (const auto ok = apply_layers(layers, request); !ok) return fail(ok.error());
  return request;
}

}  // namespace slipstick
