// `slipstick sim --gcode FILE --against MODEL`: defects planted in a program are reported.
#include <cairo.h>
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;

namespace {

/// Two upright tubes 1 mm apart, as in the paper's figure 3, in the middle of a bed of 220 mm.
constexpr const char* kTubes =
    "local tube = difference(cylinder(5, 3), cylinder(3.2, 9))\n"
    "return union(tube:move(-5.5, 0, 0), tube:move(5.5, 0, 0))\n";
constexpr double kLeft = 104.5;
constexpr double kMiddle = 110;

using Program = std::vector<std::string>;

class Bench {
 public:
  Bench() {
    std::ofstream(model_) << kTubes;
    const auto done = test::slipstick({"slice", model_, "-o", gcode_, "--layer-height", "0.3",
                                       "--certify", "off", "--threads", "1"});
    INFO(done.err);
    REQUIRE(done.status == 0);
    std::ifstream in(gcode_);
    for (std::string line; std::getline(in, line);) program_.push_back(line);
  }

  [[nodiscard]] Program program() const { return program_; }

  /// What the judge prints as JSON on `program`, and its exit status.
  test::Finished judge(const Program& program) const {
    write(program);
    return test::slipstick(
        {"sim", "--gcode", gcode_, "--against", model_, "--layer-height", "0.3", "--json"});
  }

  /// The same, and draws by `words`.
  test::Finished draw(const Program& program, const std::vector<std::string>& words) const {
    write(program);
    std::vector<std::string> all{"sim",  "--gcode",        gcode_, "--against",
                                 model_, "--layer-height", "0.3"};
    all.insert(all.end(), words.begin(), words.end());
    return test::slipstick(all);
  }

  [[nodiscard]] std::string file(const char* name) const {
    return (folder_.path() / name).string();
  }

 private:
  void write(const Program& program) const {
    std::ofstream out(gcode_);
    for (const std::string& line : program) out << line << '\n';
  }

  test::TemporaryFolder folder_;
  std::string model_ = (folder_.path() / "tubes.lua").string();
  std::string gcode_ = (folder_.path() / "tubes.gcode").string();
  Program program_;
};

/// Adds lines at the end of a layer.
void plant(Program& program, int layer, const Program& lines) {
  const auto next = std::find(program.begin(), program.end(), fmt::format(";LAYER:{}", layer + 1));
  REQUIRE(next != program.end());
  program.insert(next, lines.begin(), lines.end());
}

/// A bead of 0.45 mm by 0.3 mm.
Program bead(double x0, double y0, double x1, double y1) {
  const double e = std::hypot(x1 - x0, y1 - y0) * 0.45 * 0.3 / 2.405;
  return {fmt::format("G0 X{:.3f} Y{:.3f} F7200", x0, y0),
          fmt::format("G1 X{:.3f} Y{:.3f} E{:.5f} F1200", x1, y1, e)};
}

/// Lays nothing on the outer perimeter of the left tube in `layer`: travels instead.
void remove_outer_perimeter(Program& program, int layer) {
  auto line = std::find(program.begin(), program.end(), fmt::format(";LAYER:{}", layer));
  REQUIRE(line != program.end());
  double x = 0;
  double y = 0;
  for (++line; line != program.end() && !line->starts_with(";LAYER"); ++line) {
    if (const auto at = line->find(" X"); at != std::string::npos)
      x = std::stod(line->substr(at + 2));
    if (const auto at = line->find(" Y"); at != std::string::npos)
      y = std::stod(line->substr(at + 2));
    const auto e = line->find(" E");
    if (e == std::string::npos || line->find('X') == std::string::npos) continue;
    if (std::hypot(x - kLeft, y - kMiddle) > 4.6 && x < kMiddle) line->erase(e);
  }
}

struct Found {
  std::string kind;
  int layer;
  double x;
  double y;
};

std::vector<Found> found(const nlohmann::json& report) {
  std::vector<Found> result;
  for (const auto& d : report["defects"]) {
    result.push_back({d["kind"], d["layer"], d["x"], d["y"]});
  }
  return result;
}

bool has(const std::vector<Found>& all, const Found& wanted, double within) {
  return std::any_of(all.begin(), all.end(), [&](const Found& f) {
    return f.kind == wanted.kind && f.layer == wanted.layer &&
           std::hypot(f.x - wanted.x, f.y - wanted.y) < within;
  });
}

}  // namespace

TEST_CASE("The judge finds nothing wrong with our own program, twice the same to the bit") {
  const Bench bench;

  const auto first = bench.judge(bench.program());
  const auto second = bench.judge(bench.program());

  INFO(first.err << first.out);
  CHECK(first.status == 0);
  CHECK(first.out == second.out);
  const auto report = nlohmann::json::parse(first.out);
  CHECK(report["deposit"]["layers"] == 10);
  CHECK(report["defects"].empty());
  CHECK(report["topology"]["printed"] == report["topology"]["model"]);
  CHECK(report["topology"]["model"]["components"] == 2);
  CHECK(report["topology"]["model"]["tunnels"] == 2);
  CHECK(report["refused"]["count"] == 0);
}

TEST_CASE("The judge finds each planted defect in its layer and place, and no other") {
  const Bench bench;
  Program program = bench.program();
  plant(program, 0, bead(109.2, 110, 110.8, 110));  // merged tubes (paper, figure 3), on the bed
  for (double y = 106; y < 114; y += 0.4) {         // a membrane (figure 1)
    const double half = std::sqrt(std::max(0.0, 11.6 - (y - 110) * (y - 110)));
    plant(program, 2, bead(kLeft - half, y, kLeft + half, y));
  }
  plant(program, 4, bead(130, 110, 140, 110));  // a bridge over nothing
  remove_outer_perimeter(program, 6);

  const auto done = bench.judge(program);

  INFO(done.err << done.out);
  CHECK(done.status == 1);
  const auto report = nlohmann::json::parse(done.out);
  const auto all = found(report);
  CHECK(has(all, {"islands joined", 0, 110, 110}, 0.4));
  CHECK(has(all, {"hole closed", 2, kLeft, 110}, 1));
  CHECK(has(all, {"laid in the air", 2, kLeft, 110}, 1));
  CHECK(has(all, {"laid in the air", 4, 135, 110}, 0.5));
  CHECK(has(all, {"rim bare", 6, kLeft, 110}, 5.1));
  for (const Found& f : all) {
    INFO(f.kind << " in layer " << f.layer);
    CHECK((f.layer == 0 || f.layer == 2 || f.layer == 4 || f.layer == 6));
  }
  CHECK(report["topology"]["printed"] != report["topology"]["model"]);
}

TEST_CASE("The judge finds a layer that was left out below the top") {
  const Bench bench;
  Program program = bench.program();
  const auto from = std::find(program.begin(), program.end(), ";LAYER:5");
  program.erase(from, std::find(from, program.end(), ";LAYER:6"));

  const auto done = bench.judge(program);

  INFO(done.err << done.out);
  CHECK(done.status == 1);
  const auto report = nlohmann::json::parse(done.out);
  CHECK(report["deposit"]["layers_missing"] == 1);
  const auto& defects = report["defects"];
  const auto left_out = std::find_if(defects.begin(), defects.end(),
                                     [](const auto& d) { return d["kind"] == "layer left out"; });
  REQUIRE(left_out != defects.end());
  CHECK((*left_out)["layer"] == 5);
  CHECK((*left_out)["z"].get<double>() == Approx(1.7));  // The first is 0.2 mm, five of 0.3 follow.
}

namespace {

/// How many pixels of the picture have each colour.
std::map<std::uint32_t, int> colours_of(const std::string& png) {
  std::map<std::uint32_t, int> count;
  cairo_surface_t* image = cairo_image_surface_create_from_png(png.c_str());
  REQUIRE(cairo_surface_status(image) == CAIRO_STATUS_SUCCESS);
  const unsigned char* bytes = cairo_image_surface_get_data(image);
  for (int row = 0; row < cairo_image_surface_get_height(image); ++row) {
    for (int column = 0; column < cairo_image_surface_get_width(image); ++column) {
      std::uint32_t colour = 0;
      std::memcpy(&colour, bytes + row * cairo_image_surface_get_stride(image) + 4 * column, 4);
      ++count[colour & 0xFFFFFF];
    }
  }
  cairo_surface_destroy(image);
  return count;
}

constexpr std::uint32_t kRight = 0x5B7FB4, kTooMuch = 0xD03030;

}  // namespace

TEST_CASE("A picture shows what was laid right and what too much, of the first wrong layer") {
  const Bench bench;
  Program program = bench.program();
  plant(program, 4, bead(130, 110, 140, 110));
  const std::string wrong = bench.file("wrong.png"), chosen = bench.file("chosen.png");

  CHECK(bench.draw(program, {"--picture", wrong}).status == 1);
  CHECK(bench.draw(program, {"--picture", chosen, "--picture-layer", "3"}).status == 1);

  auto colours = colours_of(wrong), of_another = colours_of(chosen);
  CHECK(colours[kRight] > 10'000);
  CHECK(colours[kTooMuch] > 2'000);  // 4.7 mm² of a picture 41 mm across, 1000 pixels.
  CHECK(of_another[kRight] > 10'000);
  CHECK(of_another[kTooMuch] < 1'000);
}

TEST_CASE("Temperatures and speeds over time are drawn") {
  const Bench bench;
  const std::string curves = bench.file("curves.svg");

  const auto done = bench.draw(bench.program(), {"--curves", curves});
  const auto refused = bench.draw(bench.program(), {"--curves", bench.file("curves.txt")});

  INFO(done.err);
  CHECK(done.status == 0);
  std::stringstream text;
  text << std::ifstream(curves).rdbuf();
  CHECK(text.str().find("<svg") != std::string::npos);
  CHECK(text.str().size() > 10'000);
  CHECK(refused.status == 1);
  CHECK(refused.err.find("curves are .svg or .png") != std::string::npos);
}

TEST_CASE("A picture of no known form, or of a layer that is not there, is refused") {
  const Bench bench;
  const auto form = bench.draw(bench.program(), {"--picture", bench.file("a.txt")});
  const auto layer =
      bench.draw(bench.program(), {"--picture", bench.file("a.png"), "--picture-layer", "99"});

  CHECK(form.status == 1);
  CHECK(form.err.find("a picture is .png or .svg") != std::string::npos);
  CHECK(layer.status == 1);
  CHECK(layer.err.find("there is no layer 99") != std::string::npos);
}

TEST_CASE("A program that ends too early, or lays nothing, is wrong and says so") {
  const Bench bench;
  Program program = bench.program();
  program.erase(std::find(program.begin(), program.end(), ";LAYER:5"), program.end());

  const auto early = bench.judge(program);
  const auto empty = bench.judge({"G28", "G5 X1", "G1 X100 Y100 E5"});

  CHECK(early.status == 1);
  CHECK(nlohmann::json::parse(early.out)["deposit"]["top_missing"] > 1);
  CHECK(empty.status == 1);
  CHECK(empty.err.find("lays nothing where the model is (2 lines were refused, the first: G5 X1") !=
        std::string::npos);
}
