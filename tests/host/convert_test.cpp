// `slipstick convert` and `--as`: one solid in each representation.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/solid/mesh_model.h"
#include "tests/support/process.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

// Files with the verbs of the command.
class Workshop {
 public:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  std::string mesh(const std::string& name, std::size_t which, double shift = 0) const {
    const TriangleMesh mesh = test::mesh_of(test::shapes()[which], 9);
    std::ofstream file(path(name));
    file << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
    for (const Vec3& p : mesh.vertices) file << p.x + shift << ' ' << p.y << ' ' << p.z << '\n';
    for (const auto& [a, b, c] : mesh.triangles) {
      file << "3 " << a << ' ' << b << ' ' << c << '\n';
    }
    return path(name);
  }

  std::string script(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }

  [[nodiscard]] test::Finished convert(const std::string& model, const std::string& output,
                                       std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"convert", model, "-o", path(output)};
    words.insert(words.end(), more.begin(), more.end());
    return test::slipstick(words);
  }

  // The area of all layers, holes taken off, times their height, 0.4: mm³ of a model in mm.
  [[nodiscard]] double volume(const std::string& model, std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"slice",
                                   model,
                                   "-o",
                                   path("out.jsonl"),
                                   "--sampling",
                                   "0.2",
                                   "--layer-height",
                                   "0.4",
                                   "--first-layer-height",
                                   "0.4"};
    words.insert(words.end(), more.begin(), more.end());
    const auto sliced = test::slipstick(words);
    INFO(sliced.err);
    REQUIRE(sliced.status == 0);
    std::ifstream file(path("out.jsonl"));
    double sum = 0;
    for (std::string line; std::getline(file, line);) {
      const auto json = nlohmann::json::parse(line);
      if (!json.contains("loops")) continue;
      for (const auto& loop : json["loops"]) sum += 0.4 * signed_area(loop["points"]);
    }
    return sum;
  }

 private:
  static double signed_area(const nlohmann::json& points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto &p = points[i], &q = points[(i + 1) % points.size()];
      twice += p[0].get<double>() * q[1].get<double>() - q[0].get<double>() * p[1].get<double>();
    }
    return 0.5 * twice;
  }

  test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("A mesh is the same solid as it is, as images, as a tree, and converted to either") {
  const Workshop shop;
  const std::string torus = shop.mesh("torus.off", 1);
  REQUIRE(shop.convert(torus, "torus.ldni", {"--resolution", "120"}).status == 0);
  REQUIRE(shop.convert(torus, "torus.bsp").status == 0);
  const double exact = shop.volume(torus);

  // Edges of the coarse mesh are rounded by a fraction of the width, 0.1.
  for (const double other :
       {shop.volume(torus, {"--as", "ldni", "--resolution", "120"}),
        shop.volume(torus, {"--as", "bsp"}), shop.volume(shop.path("torus.ldni")),
        shop.volume(shop.path("torus.bsp"))}) {
    CHECK(std::abs(other / exact - 1) < 2e-3);
  }
}

TEST_CASE("Contours are verified against the representation that they were sliced from") {
  const Workshop shop;
  const std::string torus = shop.mesh("torus.off", 1);
  for (const std::string as : {"mesh", "ldni", "bsp"}) {
    CHECK(shop.volume(torus, {"--as", as, "--resolution", "90"}) > 0);
    const auto verified = test::slipstick(
        {"verify", shop.path("out.jsonl"), "--against", torus, "--as", as, "--resolution", "90"});
    INFO(as << ": " << verified.err);
    CHECK(verified.status == 0);
  }
}

TEST_CASE("A script becomes images by sampling") {
  const Workshop shop;
  const std::string ball = shop.script("ball.lua", "return sphere(4)\n");
  const auto done = shop.convert(ball, "ball.ldni", {"--resolution", "90", "--json"});
  INFO(done.err);
  REQUIRE(done.status == 0);
  const auto said = nlohmann::json::parse(done.out);
  CHECK(said["kind"] == "ldni");
  CHECK(said["warnings"].empty());
  CHECK(std::abs(shop.volume(shop.path("ball.ldni")) / (4.0 / 3 * M_PI * 64) - 1) < 2e-3);
}

TEST_CASE("Two solids are joined as images and as trees, and the three operations add up") {
  const Workshop shop;
  const std::string left = shop.mesh("left.off", 0), right = shop.mesh("right.off", 0, 3.5);
  const double ball = shop.volume(left);
  for (const std::string kind : {".ldni", ".bsp"}) {
    std::vector<double> volumes;
    for (const std::string operation : {"union", "intersection", "difference"}) {
      const auto done = shop.convert(
          left, operation + kind, {"--with", right, "--boolean", operation, "--resolution", "150"});
      INFO(done.err);
      REQUIRE(done.status == 0);
      volumes.push_back(shop.volume(shop.path(operation + kind)));
    }
    INFO(kind);
    CHECK(volumes[1] > 0.1 * ball);
    CHECK(std::abs(volumes[0] - (2 * ball - volumes[1])) < 4e-3 * ball);
    CHECK(std::abs(volumes[2] - (ball - volumes[1])) < 4e-3 * ball);
  }
}

TEST_CASE("With nonzero winding overlaps are solid, with parity they are void") {
  const Workshop shop;
  std::ofstream both(shop.path("both.obj"));
  const TriangleMesh ball = test::mesh_of(test::shapes()[0], 10);
  for (const double shift : {0.0, 3.0}) {
    for (const Vec3& p : ball.vertices) {
      both << "v " << p.x + shift << ' ' << p.y << ' ' << p.z << '\n';
    }
  }
  const std::size_t count = ball.vertices.size();
  for (const std::size_t first : {std::size_t{1}, count + 1}) {
    for (const auto& [a, b, c] : ball.triangles) {
      both << "f " << a + first << ' ' << b + first << ' ' << c + first << '\n';
    }
  }
  both.close();
  const double one = shop.volume(shop.mesh("one.off", 0));
  for (const std::string as : {"mesh", "ldni"}) {
    const double solid = shop.volume(shop.path("both.obj"), {"--as", as, "--resolution", "150"});
    const double hollow = shop.volume(shop.path("both.obj"),
                                      {"--as", as, "--resolution", "150", "--winding", "parity"});
    INFO(as);
    CHECK(solid > 1.2 * one);
    // What is in both counts once in one and not at all in the other; 9 cells or 10 a ball, 3 %.
    CHECK(std::abs(2 * solid - hollow - 2 * one) < 0.06 * one);
  }
}

TEST_CASE("What has no way from here to there says what would have one, and writes nothing") {
  const Workshop shop;
  const std::string ball = shop.script("ball.lua", "return sphere(4)\n");
  const std::string torus = shop.mesh("torus.off", 1);
  const auto refusal = [&](const test::Finished& done) {
    CHECK(done.status == 1);
    CHECK(std::count(done.err.begin(), done.err.end(), '\n') == 1);
    return done.err;
  };
  CHECK_THAT(refusal(shop.convert(ball, "a.bsp")), Contains("ball.lua") && Contains("a mesh"));
  CHECK_THAT(refusal(shop.convert(torus, "a.rbf")), Contains("points with normals"));
  CHECK_THAT(refusal(shop.convert(torus, "a.stl")), Contains(".ldni, .bsp and .rbf"));
  CHECK_THAT(refusal(shop.convert(shop.path("no.off"), "a.ldni")), Contains("no.off"));
  CHECK_THAT(refusal(shop.convert(torus, "a.ldni", {"--resolution", "5"})),
             Contains("rays a side"));
  CHECK_THAT(refusal(test::slipstick({"slice", ball, "--as", "ldni", "-o", shop.path("a.svg")})),
             Contains("--as"));
  for (const char* name : {"a.bsp", "a.rbf", "a.stl", "a.ldni", "a.svg"}) {
    CHECK(!std::filesystem::exists(shop.path(name)));
  }
}
