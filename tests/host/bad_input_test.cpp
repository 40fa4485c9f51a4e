// Whatever a user gives, a wrong thing is answered by one clear line and status 1, and leaves
// nothing behind.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <utility>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

class Workplace {
 public:
  std::string file(const std::string& name, const std::string& text) const {
    const auto path = folder_.path() / name;
    std::ofstream(path) << text;
    return path.string();
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  long count() const { return folder_.count(); }

 private:
  test::TemporaryFolder folder_;
};

// The one line of a failed run.
std::string refusal(const test::Finished& finished) {
  INFO(finished.err);
  CHECK(finished.status == 1);
  CHECK(finished.out.empty());
  CHECK(std::count(finished.err.begin(), finished.err.end(), '\n') == 1);
  return finished.err;
}

std::string refusal_of_slice(const Workplace& place, const std::string& model,
                             std::vector<std::string> more = {}) {
  std::vector<std::string> words{"slice", model, "-o", place.path("out.gcode")};
  words.insert(words.end(), more.begin(), more.end());
  const long before = place.count();
  const std::string line = refusal(test::slipstick(words));
  CHECK(place.count() == before);
  return line;
}

constexpr const char* kBall = "return sphere(5)\n";

}  // namespace

TEST_CASE("A missing model is named") {
  const Workplace place;

  CHECK_THAT(refusal_of_slice(place, place.path("no.lua")),
             Contains("no.lua") && Contains("No such file"));
}

TEST_CASE("A model of unknown kind is told what kinds there are") {
  const Workplace place;

  CHECK_THAT(refusal_of_slice(place, place.file("a.doc", "")),
             Contains("a.doc") && Contains(".lua, .vm, .ldni"));
}

TEST_CASE("A broken script is named with its line") {
  const Workplace place;

  CHECK_THAT(refusal_of_slice(place, place.file("a.lua", "local a = 1\nreturn sphere(\n")),
             Contains("a.lua:"));
  CHECK_THAT(refusal_of_slice(place, place.file("b.lua", "\n\nreturn spere(5)\n")),
             Contains("b.lua:3:"));
}

TEST_CASE("An endless script is stopped") {
  const Workplace place;

  CHECK_THAT(refusal_of_slice(place, place.file("a.lua", "while true do end\n")),
             Contains("a.lua:1:"));
}

TEST_CASE("A greedy script is stopped") {
  const Workplace place;

  CHECK_THAT(
      refusal_of_slice(place, place.file("a.lua",
                                         "local t = {}\n"
                                         "while true do t[#t + 1] = ('x'):rep(1e6) .. #t end\n")),
      Contains("a.lua"));
}

TEST_CASE("A script that reaches for the machine finds nothing") {
  const Workplace place;
  for (const char* text : {"os.execute('true')", "io.open('/etc/passwd')", "require('x')",
                           "load('return 1')()", "dofile('/etc/passwd')"}) {
    CHECK_THAT(refusal_of_slice(place, place.file("a.lua", text)), Contains("a.lua:1:"));
  }
}

TEST_CASE("An expression that is no number is refused with the place") {
  const Workplace place;

  CHECK_THAT(
      refusal_of_slice(place, place.file("a.lua", "return max(sphere(5), sqrt(x - 2) - 9)\n")),
      Contains("not a number"));
}

TEST_CASE("An empty solid is refused") {
  const Workplace place;

  CHECK_THAT(refusal_of_slice(place, place.file("a.lua",
                                                "return intersection(sphere(1):move(-9, 0, 0), "
                                                "sphere(1):move(9, 0, 0))\n")),
             Contains("empty"));
}

TEST_CASE("A solid beyond the build volume is refused, but its contours can be had") {
  const Workplace place;
  const std::string model = place.file("a.lua", "return sphere(500)\n");

  CHECK_THAT(refusal_of_slice(place, model), Contains("build volume") && Contains("--fit"));
  CHECK(test::slipstick({"slice", model, "-o", place.path("a.jsonl"), "--sampling", "2",
                         "--layer-height", "0.3", "--layers", "1500:1502"})
            .status == 0);
}

TEST_CASE("An output that cannot be written is refused before anything is sliced") {
  const Workplace place;
  const std::string model = place.file("a.lua", kBall);

  for (const char* name : {"/proc/none/a.gcode", "/proc/none/a.jsonl", "/proc/none/a.png"}) {
    CHECK_THAT(refusal(test::slipstick({"slice", model, "-o", name})),
               Contains("cannot write") && Contains(name));
  }
}

TEST_CASE("A full disk is told from standard output too") {
  const Workplace place;
  const std::string model = place.file("a.lua", kBall);

  const auto finished = test::run(
      {"sh", "-c", std::string(SLIPSTICK_BINARY) + " slice " + model + " -o - >/dev/full"});

  CHECK_THAT(refusal(finished), Contains("No space left"));
}

TEST_CASE("A full disk leaves nothing half written") {
  // A limit on the size of files stands for the disk; EFBIG comes where ENOSPC would.
  const Workplace place;
  const std::string model = place.file("a.lua", kBall);

  const std::array<std::pair<const char*, const char*>, 3> outputs{
      {{" slice ", "a.gcode"},
       {" convert ", "a.ldni"},
       {" figure --window 105,105,115,115 image ", "a.svg"}}};

  for (const auto& [command, output] : outputs) {
    const auto finished = test::run({"sh", "-c",
                                     "ulimit -f 8; trap '' XFSZ; " + std::string(SLIPSTICK_BINARY) +
                                         command + model + " -o " + place.path(output)});

    CHECK_THAT(refusal(finished), Contains("cannot write") && Contains(output));
    CHECK(place.count() == 1);
  }
}

TEST_CASE("A disk that fills up during a print costs the journal, not the print") {
  const Workplace place;
  std::string program;
  for (int i = 0; i < 200; ++i) program += "G1 X" + std::to_string(i % 9) + "\n";
  const std::string model = place.file("a.gcode", program);
  const std::string journal = place.path("a.journal");

  const auto finished = test::run({"sh", "-c",
                                   "ulimit -f 1; trap '' XFSZ; " + std::string(SLIPSTICK_BINARY) +
                                       " print " + model + " --port sim: --journal " + journal});

  CHECK(finished.status == 0);
  CHECK_THAT(finished.err, Contains("a.journal") && Contains("cannot be taken up"));
  CHECK(place.count() == 1);
}

TEST_CASE("A journal that cannot be used is named, and the print of another is not forgotten") {
  const Workplace place;
  const std::string model = place.file("a.gcode", "G1 X1\n");
  const std::string other = place.file("b.journal", "something else\n");

  const auto print = [&](const std::string& journal) {
    return refusal(test::slipstick({"print", model, "--port", "sim:", "--journal", journal}));
  };
  CHECK_THAT(print(other), Contains("b.journal: this is no journal"));
  CHECK_THAT(print("/nowhere/a.journal"), Contains("/nowhere/a.journal"));
  CHECK_THAT(refusal(test::slipstick({"print", "--resume", other})), Contains("b.journal"));
  CHECK_THAT(refusal(test::slipstick({"print", "--resume", place.path("c.journal")})),
             Contains("c.journal"));
}

TEST_CASE("Wrong settings name the key") {
  const Workplace place;
  const std::string model = place.file("a.lua", kBall);

  CHECK_THAT(refusal_of_slice(place, model, {"--set", "layer_hight=0.2"}),
             Contains("layer_hight") && Contains("layer_height"));
  CHECK_THAT(refusal_of_slice(place, model, {"--layer-height", "-1"}), Contains("layer_height"));
  CHECK_THAT(refusal_of_slice(place, model, {"--printer", "nonesuch"}), Contains("nonesuch"));
  CHECK_THAT(refusal_of_slice(place, model, {"--sampling", "0.0005"}), Contains("sampling"));
  CHECK_THAT(refusal_of_slice(place, model, {"--layers", "900:901"}), Contains("layers"));
}

TEST_CASE("Wrong usage is status 2") {
  CHECK(test::slipstick({"slice"}).status == 2);
  CHECK(test::slipstick({"nonsense"}).status == 2);
  CHECK(test::slipstick({"print", "a.lua"}).status == 2);
  CHECK(test::slipstick({"print", "--port", "sim:"}).status == 2);
  CHECK(test::slipstick({"print", "a.lua", "--port", "sim:", "--recover"}).status == 2);
  CHECK(test::slipstick({"print", "a.lua", "--resume", "a.journal"}).status == 2);
  for (const char* numbers : {"1,2", "1,2,3,4", "1,2,x", "1,2,", "", "1;2;3"}) {
    const auto finished = test::slipstick({"slice", "a.lua", "-o", "a.gcode", "--fit", numbers});
    CHECK(finished.status == 2);
    CHECK_THAT(finished.err, Contains("--fit") && Contains("3 numbers"));
  }
}

TEST_CASE("Options may stand before the model") {
  const Workplace place;
  const std::string model = place.file("a.lua", kBall);

  const auto finished = test::slipstick({"slice", "--fit", "9,9,9", "--set", "sampling=0.3", model,
                                         "--bounds", "0,0,0,1,1,1", "-o", place.path("a.jsonl")});

  INFO(finished.err);
  CHECK(finished.status == 0);
}

TEST_CASE("Every command has help with an example") {
  for (const char* command :
       {"slice", "print", "sim", "verify", "info", "ports", "convert", "figure", "serve"}) {
    const auto finished = test::slipstick({command, "--help"});

    CHECK(finished.status == 0);
    CHECK_THAT(finished.out, Contains("Example: slipstick " + std::string(command)));
  }
}
