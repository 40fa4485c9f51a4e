#include <catch2/catch.hpp>
#include <fstream>

#include "tests/host/grey_picture.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

/// A ball over a cube; on the bed layers from 4 to 8 mm are empty.
const std::string kTwoParts = "return union(sphere(2):move(0, 0, 8), box(4, 4, 4))";

class Figures {
 public:
  Figures() { std::ofstream(folder_.path() / "parts.lua") << kTwoParts; }

  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] test::Finished draw(const std::string& kind, const std::string& output,
                                    const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"figure", kind, file("parts.lua"), "-o", file(output)};
    words.insert(words.end(), more.begin(), more.end());
    return test::slipstick(words);
  }

  /// Files besides the model.
  [[nodiscard]] long files() const { return folder_.count() - 1; }

 private:
  test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("Every kind of figure is drawn, as .svg and as .png") {
  const Figures figures;
  for (const char* kind : {"image", "stages", "segments", "stack"}) {
    for (const char* name : {"a.svg", "a.png"}) {
      const std::vector<std::string> layer = std::string(kind) == "stack"
                                                 ? std::vector<std::string>{}
                                                 : std::vector<std::string>{"--height", "1"};
      const auto done = figures.draw(kind, kind + std::string(name), layer);
      INFO(done.err);
      CHECK(done.status == 0);
    }
  }
  CHECK(figures.files() == 8);
  CHECK(test::GreyPicture(figures.file("stacka.png")).width() > 100);
}

TEST_CASE("The slicing direction turns the figure: a cube is as wide as it is high, both are not") {
  const Figures figures;
  REQUIRE(figures.draw("image", "up.png", {"--height", "1"}).status == 0);
  REQUIRE(figures.draw("image", "side.png", {"--direction", "0,1,0"}).status == 0);

  const test::GreyPicture up(figures.file("up.png")), side(figures.file("side.png"));
  CHECK(up.width() == up.height());
  CHECK(side.width() != side.height());
}

TEST_CASE("What cannot be drawn is told with what, where and what to do, and nothing is written") {
  const Figures figures;
  struct Wrong {
    const char* kind;
    const char* output;
    std::vector<std::string> more;
    const char* message;
  };
  const std::vector<Wrong> wrongs{
      {"image", "a.svg", {"--layer", "900"}, "parts.lua: --layer 900: there is no such layer"},
      {"image", "a.svg", {"--height", "99"}, "parts.lua: --height 99: no layer is there"},
      {"segments", "a.svg", {"--height", "6"}, "is empty: no sample is inside; choose another"},
      {"stages", "a.svg", {"--window", "0,0,1,1", "--layer", "3"}, "no sample of the layer is"},
      {"stages", "a.svg", {"--window", "1,0,0,1"}, "--window wants X0<X1"},
      {"image", "a.gif", {}, "figures are .svg or .png"},
      {"image", "nowhere/a.png", {}, "nowhere"},
      {"stack", "a.png", {"--layer", "3"}, "figure stack shows all layers"},
      {"stack", "a.png", {"--layers", "23:27"}, "nothing to draw: no sample"},
      {"image", "a.png", {"--layers", "1:2"}, "figure image shows one layer"},
  };
  for (const Wrong& wrong : wrongs) {
    const auto done = figures.draw(wrong.kind, wrong.output, wrong.more);

    INFO(wrong.message);
    CHECK(done.status == 1);
    CHECK_THAT(done.err, Contains(wrong.message));
    CHECK(figures.files() == 0);
  }
  CHECK(figures.draw("portrait", "a.svg").status == 2);
  CHECK(figures.draw("image", "a.svg", {"--layer", "1", "--height", "1"}).status == 2);
}
