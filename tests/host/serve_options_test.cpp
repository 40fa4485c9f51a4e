// What `slipstick serve` is told, as words and in a file.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/support/child_process.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

class Folder {
 public:
  std::string file(const std::string& text) const {
    std::ofstream(path("serve.toml")) << text;
    return path("serve.toml");
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

 private:
  test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("Options may stand in a file, and words win") {
  const Folder folder;
  const std::string config = folder.file("# a printer\ndata = \"" + folder.path("file") +
                                         "\"\nlisten = \"127.0.0.1:0\"\nprinter = \"sim:\"\n");
  {
    test::ChildProcess daemon({"serve", "--config", config});
    CHECK_THAT(daemon.line(), Contains("listening on http://127.0.0.1:"));
    CHECK(std::filesystem::exists(folder.path("file")));
  }
  test::ChildProcess daemon({"serve", "--data", folder.path("word"), "--config", config});
  CHECK_THAT(daemon.line(), Contains("listening on http://127.0.0.1:"));
  CHECK(std::filesystem::exists(folder.path("word")));
}

TEST_CASE("What is wrong in a file of options is told with its name") {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    const auto done = test::slipstick({"serve", "--config", folder.file(text)});
    CHECK(done.status == 2);
    CHECK_FALSE(std::filesystem::exists(folder.path("data")));
    return done.err;
  };
  const std::string data = "data = \"" + folder.path("data") + "\"\n";
  CHECK_THAT(refused(data + "lisen = \"127.0.0.1:0\"\n"),
             Contains("serve.toml") && Contains("lisen"));
  CHECK_THAT(refused(data + "mqtt-commands = \"maybe\"\n"), Contains("serve.toml"));
  CHECK_THAT(refused(data + "config = \"other.toml\"\n"), Contains("serve.toml"));
  const auto missing = test::slipstick({"serve", "--config", folder.path("no.toml")});
  CHECK(missing.status == 2);
  CHECK_THAT(missing.err, Contains("no.toml"));
}
