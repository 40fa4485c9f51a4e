#include "host/atomic_file.h"

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.h"

using namespace slipstick;
namespace fs = std::filesystem;

TEST_CASE("A file appears only when committed") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "out.gcode";
  {
    auto file = AtomicFile::create(path);
    REQUIRE(file);
    REQUIRE(file->write("G28\n"));
    CHECK_FALSE(fs::exists(path));

    REQUIRE(file->commit());
  }
  CHECK(*read_file(path) == "G28\n");
  CHECK(folder.count() == 1);
}

TEST_CASE("What is not committed leaves nothing and keeps the old file") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "out.gcode";
  REQUIRE(write_file(path, "old"));
  {
    auto file = AtomicFile::create(path);
    REQUIRE(file->write("new"));
  }
  CHECK(*read_file(path) == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("A file that cannot be made is an error with its reason") {
  const auto ok = write_file("/proc/none/x", "bytes");

  REQUIRE_FALSE(ok);
  CHECK_THAT(ok.error().message, Catch::Contains("cannot write /proc/none/x"));
}

TEST_CASE("A missing file and a folder cannot be read, and the message names them") {
  const test::TemporaryFolder folder;

  CHECK_THAT(read_file(folder.path() / "no").error().message,
             Catch::Contains("no: No such file or directory"));
  CHECK_THAT(read_file(folder.path()).error().message, Catch::Contains("Is a directory"));
  CHECK_FALSE(AtomicFile::create(folder.path()));
}
