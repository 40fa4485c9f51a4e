// What a report says about proofs and topology, and what strict certification does.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

class Workplace {
 public:
  test::Finished slice(const std::string& name, const std::string& text,
                       std::vector<std::string> more = {}) const {
    const auto model = folder_.path() / name;
    std::ofstream(model) << text;
    std::vector<std::string> words{"slice", model.string(), "-o",
                                   (folder_.path() / "out.jsonl").string(), "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return test::slipstick(words);
  }
  nlohmann::json report(const std::string& name, const std::string& text,
                        const std::vector<std::string>& more = {}) const {
    const test::Finished finished = slice(name, text, more);
    INFO(finished.err);
    REQUIRE(finished.status == 0);
    return nlohmann::json::parse(finished.out);
  }

 private:
  test::TemporaryFolder folder_;
};

constexpr const char* kRing = "return torus(3, 1)\n";
// A bubble that no plane of 0.2 mm layers cuts.
constexpr const char* kBubble = "return difference(torus(3, 1), sphere(0.07):move(3, 0, 0.2))\n";
constexpr const char* kTetrahedron =
    "solid t\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 9 0\nvertex 9 0 0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 0 9\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 9\nvertex 0 9 0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 9 0 0\nvertex 0 9 0\nvertex 0 0 9\nendloop\nendfacet\n"
    "endsolid t\n";

}  // namespace

TEST_CASE("A report tells the topology of the print and what is proved") {
  const auto report = Workplace().report("ring.lua", kRing);

  CHECK(report["topology"]["components"] == 1);
  CHECK(report["topology"]["tunnels"] == 1);
  CHECK(report["topology"]["cavities"] == 0);
  CHECK(report["certified"]["cells"] > 1000);
  CHECK(report["certified"]["events"] == 0);
  CHECK(report["certified"]["steps"] >= 2);
  CHECK(report["aligned"] == true);
}

TEST_CASE("Strict certification fails with layer, place and advice; report tells the same") {
  const Workplace place;

  const auto report = place.report("bubble.lua", kBubble);
  const test::Finished strict = place.slice("bubble.lua", kBubble, {"--certify", "strict"});

  CHECK(report["certified"]["events"] == 1);
  CHECK_THAT(report["certified"]["first"].back()["what"].get<std::string>(),
             Contains("thinner than the layer"));
  CHECK(strict.status == 1);
  CHECK_THAT(strict.err, Contains("layer") && Contains("--layer-height"));
}

TEST_CASE("Where nothing can be certified the report says why") {
  const Workplace place;

  const auto mesh = place.report("t.stl", kTetrahedron, {"--sampling", "0.2"});
  const auto off = place.report("ring.lua", kRing, {"--certify", "off", "--sampling", "0.2"});
  const test::Finished strict = place.slice("t.stl", kTetrahedron, {"--certify", "strict"});

  CHECK_THAT(mesh["certified"]["why"].get<std::string>(), Contains("not a formula"));
  CHECK_THAT(off["certified"]["why"].get<std::string>(), Contains("off"));
  CHECK(strict.status == 1);
  CHECK_THAT(strict.err, Contains("nothing can be certified"));
}

TEST_CASE("A regularized formula is not certified") {
  const Workplace place;

  const auto report = place.report("ring.lua", kRing, {"--regularize", "0.3", "--sampling", "0.2"});
  const test::Finished strict =
      place.slice("ring.lua", kRing, {"--regularize", "0.3", "--certify", "strict"});

  CHECK_THAT(report["certified"]["why"].get<std::string>(), Contains("regularized"));
  CHECK(strict.status == 1);
  CHECK_THAT(strict.err, Contains("regularized") && Contains("--certify report"));
}

TEST_CASE("Layers are a whole number of lattice widths, and the report says where they cannot be") {
  const Workplace place;
  const auto aligned = [&](const std::string& sampling, const std::string& first) {
    return place.report("ring.lua", kRing,
                        {"--layers", "3:5", "--layer-height", "0.2", "--first-layer-height", first,
                         "--sampling", sampling});
  };

  const auto finer = aligned("0.15", "0.2");

  CHECK(finer["aligned"] == true);
  CHECK(finer["lattice_width"].get<double>() == Approx(0.1).epsilon(1e-5));
  CHECK(aligned("0.1", "0.4")["aligned"] == true);
  CHECK(aligned("0.1", "0.25")["aligned"] == false);
  CHECK(aligned("0.3", "0.2")["aligned"] == false);
}
