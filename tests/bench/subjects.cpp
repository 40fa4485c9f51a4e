#include "tests/bench/subjects.h"

#include <fmt/format.h>

#include <cstdlib>

#include "core/base/check.h"
#include "core/base/rng.h"
#include "core/formats/lua_script.h"
#include "core/job/placement.h"
#include "host/load_model.h"

namespace slipstick::bench {
namespace {

std::shared_ptr<const Solid> on_bed(const Model& model, const PlacementRequest& request) {
  const auto placed = place_on_bed(model, request, {0, 0});
  SLIPSTICK_CHECK(placed.has_value());
  return placed->solid;
}

// Added to f: nothing within 45 mm of the axis, steep beyond, so that smooth shapes end smoothly.
constexpr std::string_view kRim = "((x * x + y * y) / 2200) ^ 16";

// Twelve waves of random direction, length and phase.
std::string blobs_script() {
  Rng rng(7);
  std::string sum;
  for (int wave = 0; wave < 12; ++wave) {
    sum += fmt::format("sin({:.6f} * x + {:.6f} * y + {:.6f} * z + {:.6f}) + ",
                       (rng.unit() - 0.5) * 1.6, (rng.unit() - 0.5) * 1.6, (rng.unit() - 0.5) * 0.8,
                       rng.unit() * 6.3);
  }
  return fmt::format("return ({}{}):bounds(-50, -50, -5, 50, 50, 5)", sum, kRim);
}

// Sheets of a gyroid of period 9.
std::string gyroid_script() {
  return fmt::format(
      "local k = 2 * math.pi / 9\n"
      "local g = sin(k * x) * cos(k * y) + sin(k * y) * cos(k * z) + sin(k * z) * cos(k * x)\n"
      "return (g ^ 2 - 0.16 + {}):bounds(-50, -50, -5, 50, 50, 5)",
      kRim);
}

constexpr std::string_view kTruss =
    "local s = {}\n"
    "for i = 0, 5 do for j = 0, 5 do\n"
    "  local x0, y0 = i * 16 - 48, j * 16 - 48\n"
    "  s[#s + 1] = capsule(x0, y0, -6, x0 + 16, y0 + 16, 6, 1.1)\n"
    "  s[#s + 1] = capsule(x0 + 16, y0, -6, x0, y0 + 16, 6, 1.1)\n"
    "  s[#s + 1] = capsule(x0 + 8, y0 - 8, 6, x0 + 8, y0 + 8, -6, 0.9)\n"
    "end end\n"
    "return union(table.unpack(s))";

}  // namespace

std::shared_ptr<const Solid> lua_solid(std::string_view script) {
  const auto model = load_lua_model(script, "target");
  SLIPSTICK_CHECK(model.has_value());
  return on_bed(**model, {});
}

std::shared_ptr<const Solid> vm_solid(const std::string& path, double size) {
  const auto loaded = load_model(path, {});
  SLIPSTICK_CHECK(loaded.has_value());
  PlacementRequest request;
  request.scale = size / 2;
  return on_bed(*loaded->model, request);
}

Subject subject(std::string name, std::shared_ptr<const Solid> solid, double sampling, double z) {
  const Box3 bounds = solid->bounds();
  const auto grid =
      SliceGrid::over({{bounds.low.x, bounds.low.y}, {bounds.high.x, bounds.high.y}}, sampling);
  SLIPSTICK_CHECK(grid.has_value());
  return {std::move(name), std::move(solid), z < 0 ? bounds.high.z / 2 : z, *grid};
}

std::vector<Subject> smooth_subjects() {
  std::vector<Subject> subjects{subject("circle", lua_solid("return cylinder(45.03, 10)"), 0.1),
                                subject("blobs", lua_solid(blobs_script()), 0.1),
                                subject("gyroid sheet", lua_solid(gyroid_script()), 0.1)};
  for (Subject& s : subjects) s.smooth = true;
  return subjects;
}

std::vector<Subject> edge_subjects() {
  std::vector<Subject> subjects = smooth_subjects();
  subjects.push_back(
      subject("turned square", lua_solid("return box(70, 70, 10):rotate(0, 0, 17)"), 0.1));
  subjects.push_back(subject("truss", lua_solid(kTruss), 0.1, 5.3));
  const std::string solids = std::string(SLIPSTICK_SOURCE_DIR) + "/configs/solids/";
  for (const char* name : {"gyroid_sphere", "bracket", "twisted_vase", "schwarz_cube"}) {
    const auto loaded = load_model(solids + name + ".lua", {});
    SLIPSTICK_CHECK(loaded.has_value());
    subjects.push_back(subject(name, on_bed(*loaded->model, {}), 0.1));
  }
  return subjects;
}

PlacedSolid example_on_bed() {
  const auto loaded =
      load_model(std::string(SLIPSTICK_SOURCE_DIR) + "/configs/solids/gyroid_sphere.lua", {});
  SLIPSTICK_CHECK(loaded.has_value());
  const auto placed = place_on_bed(*loaded->model, {}, {100, 100});
  SLIPSTICK_CHECK(placed.has_value());
  return *placed;
}

std::vector<Subject> filigree_layers() {
  constexpr double kInch = 25.4;
  constexpr double kSampling = 0.0025 * kInch;  // paper, table 1
  std::vector<Subject> subjects{
      subject(
          "rings",
          lua_solid(
              "return torus(3.6, 1):array(48.5, 38.8, 0, 5, 6, 1):bounds(-5, -5, -1, 199, 199, 1)"),
          kSampling),
      subject("gyroid", lua_solid("return intersection(box(203, 203, 10), gyroid(150, 30))"),
              kSampling)};
  if (const std::string folder = models_folder(); !folder.empty()) {
    const auto loaded = load_model(folder + "/syn_filigree.ply", {});
    SLIPSTICK_CHECK(loaded.has_value());
    PlacementRequest request;
    request.fit = Vec3{8 * kInch, 8 * kInch, 8 * kInch};
    subjects.push_back(subject("syn_filigree.ply", on_bed(*loaded->model, request), kSampling));
  }
  return subjects;
}

std::string models_folder() {
  const char* folder = std::getenv("SLIPSTICK_MODELS");  // NOLINT(concurrency-mt-unsafe)
  return folder == nullptr ? "" : folder;
}

}  // namespace slipstick::bench
