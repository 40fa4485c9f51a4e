#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <set>

#include "core/contour/trace.h"
#include "core/formats/lua_script.h"
#include "core/image/sample.h"
#include "host/atomic_file.h"
#include "host/figures/image_figure.h"
#include "host/figures/segments_figure.h"
#include "host/figures/stack_figure.h"
#include "host/figures/stages_figure.h"
#include "tests/host/grey_picture.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

/// A tube with a slot, 8 mm across and 3 mm high, as it lies on the bed.
PlacedSolid tube(Vec3 direction = {0, 0, 1}) {
  const auto model = load_lua_model(
      "local r = math.max and sqrt(x * x + y * y)\n"
      "return difference(intersection(max(r - 4, 2 - r), box(20, 20, 3)), box(20, 0.7, 20))",
      "tube.lua");
  if (!model) FAIL(model.error().message);
  PlacementRequest request;
  request.direction = direction;
  const auto placed = place_on_bed(**model, request, {50, 50});
  if (!placed) FAIL(placed.error().message);
  return *placed;
}

SlicingRequest coarse(double sampling = 0.25) {
  SlicingRequest request;
  request.goal = SliceGoal::kContours;
  request.threads = 1;
  request.settings.slicing.sampling = sampling;
  request.settings.slicing.layer_height = request.settings.slicing.first_layer_height = 0.25;
  request.settings.slicing.certify = Certification::kOff;
  return request;
}

FigureLayer layer_of(const PlacedSolid& placed, const SlicingRequest& request,
                     const LayerChoice& choice = {}) {
  const auto layer = figure_layer(placed, request, choice);
  if (!layer) FAIL(layer.error().message);
  return *layer;
}

std::size_t times(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

std::string text_of(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes) FAIL(bytes.error().message);
  return *bytes;
}

}  // namespace

TEST_CASE("The picture of a layer has exactly the bits of its samples, in every direction") {
  const test::TemporaryFolder folder;
  const double sampling = GENERATE(0.25, 0.05, 0.008);  // discs, large squares, one pixel a node
  const Vec3 direction = GENERATE(Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{1, 1, 1});
  const PlacedSolid placed = tube(direction);
  const FigureLayer layer = layer_of(placed, coarse(sampling), {{}, 2.6});
  const auto image = sample(*placed.solid->section(layer.middle), layer.image->grid());
  REQUIRE(image);

  REQUIRE(draw_image(layer, {}, folder.path() / "layer.png"));

  const test::GreyPicture picture(folder.path() / "layer.png");
  const int side = picture.width() / image->columns();
  CHECK(picture.width() == side * image->columns());
  CHECK(picture.height() == side * image->rows());
  CHECK((sampling == 0.008) == (side == 1));
  int wrong = 0;
  for (int row = 0; row < image->rows(); ++row) {
    for (int column = 0; column < image->columns(); ++column) {
      const int x = column * side + side / 2, y = (image->rows() - 1 - row) * side + side / 2;
      if (picture.dark(x, y) != image->at(column, row)) ++wrong;
    }
  }
  CHECK(wrong == 0);
  CHECK(image->any());
}

TEST_CASE("A window shows the nodes that lie in it and no others") {
  const test::TemporaryFolder folder;
  const FigureLayer layer = layer_of(tube(), coarse());
  const SliceGrid& grid = layer.image->grid();
  const Box2 window{{grid.node_x(3), grid.node_y(2)}, {grid.node_x(9) + 0.1, grid.node_y(6)}};

  const auto nodes = nodes_in(window, grid);
  REQUIRE(draw_image(layer, window, folder.path() / "part.png"));

  REQUIRE(nodes);
  CHECK(nodes->first_column == 3);
  CHECK(nodes->end_column == 10);
  CHECK(nodes->first_row == 2);
  CHECK(nodes->end_row == 7);
  const test::GreyPicture picture(folder.path() / "part.png");
  CHECK(picture.width() == 7 * node_pixels(*nodes));
  CHECK(picture.height() == 5 * node_pixels(*nodes));
}

TEST_CASE("A layer is found by its number and by any height within it; others are named") {
  const PlacedSolid placed = tube();

  CHECK(layer_of(placed, coarse()).index == 6);
  CHECK(layer_of(placed, coarse(), {4, {}}).index == 4);
  CHECK(layer_of(placed, coarse(), {{}, 1.1}).index == 4);
  CHECK(layer_of(placed, coarse(), {{}, 0}).index == 0);
  CHECK(layer_of(placed, coarse(), {{}, 3}).index == 11);
  CHECK_THAT(figure_layer(placed, coarse(), {12, {}}).error().message,
             Contains("--layer 12: there is no such layer; the model has layers 0 to 11"));
  CHECK_THAT(figure_layer(placed, coarse(), {-1, {}}).error().message, Contains("--layer -1"));
  for (const double height : {-0.1, 3.2, std::nan("")}) {
    CHECK_THAT(figure_layer(placed, coarse(), {{}, height}).error().message,
               Contains("no layer is there; the layers reach from 0 to 3 mm"));
  }
}

TEST_CASE("Each region of the clustering is drawn in a colour of its own") {
  const test::TemporaryFolder folder;
  const PlacedSolid placed = tube();
  const FigureLayer layer = layer_of(placed, coarse(0.1));
  SlicingSettings settings = coarse(0.1).settings.slicing;
  settings.alpha = GENERATE(5, 10, 40);

  const Segmentation segmentation = segmentation_of(placed, layer, settings);
  REQUIRE(draw_segments(layer, segmentation, {}, folder.path() / "segments.svg"));

  const std::string svg = text_of(folder.path() / "segments.svg");
  const std::regex coloured("stroke-width:2.5;[^\"]*stroke:(rgb\\([^)]*\\))");
  std::set<std::string> colours;
  for (std::sregex_iterator it(svg.begin(), svg.end(), coloured), end; it != end; ++it) {
    colours.insert((*it)[1]);
  }
  CHECK(colours.size() == segmentation.regions.size());
  // One vertex of the outline, one disc.
  const std::size_t discs = segmentation.simplified.edges();
  const std::regex dots("stroke-width:4;[^>]*d=\"([^\"]*)\"");
  std::size_t drawn = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), dots), end; it != end; ++it) {
    drawn += times((*it)[1], "M ");
  }
  CHECK(drawn == discs);
}

TEST_CASE("The regions of the clustering cover every edge once, and are fewer the larger alpha") {
  const PlacedSolid placed = tube();
  const FigureLayer layer = layer_of(placed, coarse(0.1));
  const ContourSet traced = trace(*layer.image, Ambiguity::kSolid);
  std::size_t before = traced.sticks().size() + 1;
  for (const int alpha : {1, 4, 10, 30}) {
    SlicingSettings settings = coarse(0.1).settings.slicing;
    settings.alpha = alpha;

    const Segmentation segmentation = segmentation_of(placed, layer, settings);

    std::size_t edges = 0;
    for (const DrawnLoop& region : segmentation.regions) edges += region.size() - 1;
    CHECK(edges == traced.sticks().size());
    CHECK(segmentation.regions.size() < before);
    CHECK(segmentation.simplified.edges() >= segmentation.regions.size());
    before = segmentation.regions.size();
  }
}

TEST_CASE("The stages show the same window five times, where the longest contour turns most") {
  const test::TemporaryFolder folder;
  const PlacedSolid placed = tube();
  const FigureLayer layer = layer_of(placed, coarse(0.1));

  const Box2 window = most_curved_window(*layer.image, Ambiguity::kSolid);
  REQUIRE(draw_stages(placed, layer, Ambiguity::kSolid, {}, folder.path() / "stages.svg"));

  // A corner of the slot: on one of the two circles, beside the slot.
  const Vec2 middle = 0.5 * (window.low + window.high) - Vec2{50, 50};
  const double radius = length(middle);
  CHECK(std::min(std::abs(radius - 4), std::abs(radius - 2)) < 0.2);
  CHECK(std::abs(std::abs(middle.y) - 0.35) < 0.3);
  const std::string svg = text_of(folder.path() / "stages.svg");
  const std::regex contour("stroke-width:1.8;[^>]*d=\"([^\"]*)\"");
  std::set<std::string> shapes;
  std::size_t contours = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), contour), end; it != end; ++it) {
    shapes.insert((*it)[1]);
    ++contours;
  }
  CHECK(contours >= 5);
  CHECK(shapes.size() == contours);  // no stage is another's copy
}

TEST_CASE("A window without samples, without a contour or too wide is an error that says so") {
  const test::TemporaryFolder folder;
  const PlacedSolid placed = tube();
  const FigureLayer layer = layer_of(placed, coarse(0.05));
  const auto drawn = [&](const Box2& window) {
    return draw_stages(placed, layer, Ambiguity::kSolid, window, folder.path() / "no.svg");
  };

  CHECK_THAT(drawn({{0, 0}, {1, 1}}).error().message, Contains("no sample of the layer is there"));
  CHECK_THAT(drawn({{49, 49}, {51, 51}}).error().message, Contains("no contour passes there"));
  CHECK_THAT(drawn({{46, 46}, {54, 54}}).error().message, Contains("at most 120"));
  CHECK(folder.count() == 0);
}

TEST_CASE("The stack draws every layer, or as many as it may, evenly") {
  const test::TemporaryFolder folder;
  SlicingRequest request = coarse();
  const double height = GENERATE(0.25, 0.005);
  request.settings.slicing.layer_height = request.settings.slicing.first_layer_height = height;
  const PlacedSolid placed = tube();
  auto job = SlicingJob::start(placed, request);
  if (!job) FAIL(job.error().message);
  const int layers = (*job)->end_layer();

  REQUIRE(draw_stack(**job, 500, folder.path() / "stack.svg"));

  const std::string svg = text_of(folder.path() / "stack.svg");
  CHECK(layers == std::lround(3 / height));
  CHECK(times(svg, "fill-rule:evenodd;") ==
        static_cast<std::size_t>(std::min(layers, kStackLayersMax)));
}
