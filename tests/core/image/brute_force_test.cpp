// The image is that of the whole expression at every node, whatever was known of boxes, and
// whatever vectors the processor has.
#include <hwy/highway.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/expr/block.h"
#include "core/formats/lua_script.h"
#include "core/formats/vm_text.h"
#include "core/image/sample.h"
#include "core/job/placement.h"

using namespace slipstick;
namespace fs = std::filesystem;

namespace {

constexpr int kNodesAcross = 150;
constexpr int kNodesAcrossReal = 60;  // of thousands of operations each

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The whole expression at every node, row by row: nothing is known of boxes, nothing left out.
BitImage asked_row_by_row(const Solid& solid, double z, const SliceGrid& grid) {
  const auto section = solid.section(z);
  BitImage image(grid);
  std::vector<double> xs, ys;
  for (int column = 1; column < grid.columns() - 1; ++column) xs.push_back(grid.node_x(column));
  std::vector<std::uint8_t> inside(xs.size());
  for (int row = 1; row < grid.rows() - 1; ++row) {
    ys.assign(xs.size(), grid.node_y(row));
    section->classify(xs, ys, inside);
    for (std::size_t i = 0; i < inside.size(); ++i) {
      if (inside[i] != 0) image.set(static_cast<int>(i) + 1, row, true);
    }
  }
  return image;
}

void check_same_image(const Model& model, const std::string& name, int nodes_across) {
  PlacementRequest request;
  request.rotate = {10, 20, 30};
  const auto placed = place_on_bed(model, request, {0, 0});
  REQUIRE(placed.has_value());
  const Box3 box = placed->solid->bounds();
  const double width = std::max(box.size().x, box.size().y) / nodes_across;
  const auto grid = SliceGrid::over({{box.low.x, box.low.y}, {box.high.x, box.high.y}}, width);
  REQUIRE(grid.has_value());
  for (const double share : {0.03, 0.5, 0.81}) {
    INFO(name << " at " << share);
    const double z = box.low.z + share * box.size().z;
    const auto image = sample(*placed->solid->section(z), *grid);
    REQUIRE(image.has_value());
    CHECK(*image == asked_row_by_row(*placed->solid, z, *grid));
  }
}

// Says to the kernels what the processor can do, and takes it back.
class OnlyTarget {
 public:
  explicit OnlyTarget(std::int64_t target) { choose(target); }
  ~OnlyTarget() { choose(0); }
  OnlyTarget(const OnlyTarget&) = delete;
  OnlyTarget& operator=(const OnlyTarget&) = delete;

 private:
  static void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace

TEST_CASE("Images of the example solids are those of the whole expression at every node") {
  for (const fs::path& path : files_in(fs::path(SLIPSTICK_SOURCE_DIR) / "configs/solids", ".lua")) {
    const auto model = load_lua_model(text_of(path), path.string());
    REQUIRE(model.has_value());
    check_same_image(**model, path.filename().string(), kNodesAcross);
  }
}

TEST_CASE("Images of real expressions are those of the whole expression at every node") {
  const char* models = std::getenv("SLIPSTICK_MODELS");  // NOLINT(concurrency-mt-unsafe)
  if (models == nullptr) {
    WARN("skipped: SLIPSTICK_MODELS names no folder of models");
    return;
  }
  for (const fs::path& path : files_in(models, ".vm")) {
    const auto model = load_vm_model(text_of(path), path.string(), {{-1, -1, -1}, {1, 1, 1}});
    REQUIRE(model.has_value());
    check_same_image(**model, path.filename().string(), kNodesAcrossReal);
  }
}

TEST_CASE("All vectors that the processor has give one image") {
  const std::string file = GENERATE("gyroid_sphere.lua", "bracket.lua");
  const auto model =
      load_lua_model(text_of(fs::path(SLIPSTICK_SOURCE_DIR) / "configs/solids" / file), file);
  REQUIRE(model.has_value());
  const auto solid = (*model)->placed({});
  const Box3 box = solid->bounds();
  const auto grid = SliceGrid::over({{box.low.x, box.low.y}, {box.high.x, box.high.y}}, 0.2);
  const double z = box.low.z + 0.1 * box.size().z;
  const auto image = [&] { return sample(*solid->section(z), *grid).value(); };
  const BitImage best = image();
  const auto targets = hwy::SupportedAndGeneratedTargets();
  CHECK(best.any());
  for (const std::int64_t target : targets) {
    INFO(hwy::TargetName(target));
    const OnlyTarget only(target);
    CHECK(image() == best);
  }
}
