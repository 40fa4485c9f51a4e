// Meshes as they are found: with overlaps, open edges, doubled and turned faces.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/formats/mesh.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_off(const std::string& path, const TriangleMesh& mesh) {
  std::ofstream file(path);
  file.precision(17);
  file << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const Vec3& p : mesh.vertices) file << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const auto& [a, b, c] : mesh.triangles) file << "3 " << a << ' ' << b << ' ' << c << '\n';
}

// Contours of a model 40 mm high or wide, without the line that names it; every layer audited.
std::string contours(const test::TemporaryFolder& folder, const std::string& model,
                     const std::string& as) {
  const std::string out = (folder.path() / "out.jsonl").string();
  const std::string report = (folder.path() / "report.json").string();
  const auto done =
      test::slipstick({"slice", model, "-o", out, "--as", as, "--fit", "40,40,40", "--sampling",
                       "0.2", "--layer-height", "0.4", "--resolution", "256", "--report", report});
  INFO(done.err);
  REQUIRE(done.status == 0);
  const auto said = nlohmann::json::parse(text_of(report));
  CHECK(said["verified"]["layers"] == said["layers"]);
  CHECK(said["verified"]["layers"] > 10);
  CHECK(said["verified"]["violations"] == 0);
  const std::string text = text_of(out);
  return text.substr(text.find('\n'));
}

}  // namespace

TEST_CASE("Scans with overlaps and open edges have contours that pass the audit in every layer") {
  const char* models = std::getenv("SLIPSTICK_MODELS");
  if (models == nullptr) {
    WARN("skipped: SLIPSTICK_MODELS is not set");
    return;
  }
  const test::TemporaryFolder folder;
  for (const std::string name :
       {"self_intersectA", "man_selfint", "hand_bones_myosim", "spine_myosim"}) {
    INFO(name);
    const std::string file = std::string(models) + "/" + name + ".ply";
    contours(folder, file, "ldni");
    const std::string plain = contours(folder, file, "mesh");

    const auto mesh = read_mesh(text_of(file), "ply");
    REQUIRE(mesh);
    TriangleMesh doubled = *mesh, turned = *mesh;
    doubled.triangles.insert(doubled.triangles.end(), mesh->triangles.begin(),
                             mesh->triangles.end());
    std::swap(turned.triangles[500][0], turned.triangles[500][1]);
    for (const auto& [what, changed] :
         {std::pair("doubled.off", doubled), {"turned.off", turned}}) {
      INFO(what);
      const std::string path = (folder.path() / what).string();
      write_off(path, changed);
      const bool is_same = contours(folder, path, "mesh") == plain;
      CHECK(is_same);
      const auto info = test::slipstick({"info", path, "--json"});
      CHECK(nlohmann::json::parse(info.out)["warning"] != "");
    }
  }
}
