// docs/GALLERY.md: what it shows is there, and its commands are commands.
#include <catch2/catch.hpp>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "host/atomic_file.h"
#include "tests/support/process.h"

using namespace slipstick;

namespace {

namespace fs = std::filesystem;

const fs::path kDocs = fs::path(SLIPSTICK_SOURCE_DIR) / "docs";
constexpr std::uintmax_t kPictureBytesMax = 150'000, kAllBytesMax = 1'500'000;

std::set<std::string> found(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::set<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    all.insert((*it)[1]);
  }
  return all;
}

std::string gallery() {
  const auto text = read_file(kDocs / "GALLERY.md");
  if (!text) FAIL(text.error().message);
  return *text;
}

std::vector<std::string> words_of(const std::string& command) {
  std::istringstream stream(command);
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

TEST_CASE("Every picture of the gallery is there, small, and shown") {
  const std::set<std::string> shown = found(gallery(), R"(\]\(gallery/([^)]+)\))");

  std::uintmax_t bytes = 0;
  std::set<std::string> there;
  for (const auto& entry : fs::directory_iterator(kDocs / "gallery")) {
    there.insert(entry.path().filename().string());
    CHECK(entry.file_size() > 0);
    CHECK(entry.file_size() < kPictureBytesMax);
    bytes += entry.file_size();
  }
  CHECK(shown.size() >= 8);
  CHECK(shown == there);
  CHECK(bytes < kAllBytesMax);
}

TEST_CASE("Every command of the gallery is one that the program knows, models and all") {
  const std::set<std::string> commands = found(gallery(), "(?:^|\n)    slipstick ([^\n]+)");

  CHECK(commands.size() >= 8);
  for (const std::string& command : commands) {
    INFO(command);
    std::vector<std::string> words = words_of(command);
    for (const std::string& word : words) {
      if (word.rfind("configs/", 0) == 0) CHECK(fs::exists(kDocs.parent_path() / word));
    }
    // All of it is read, and nothing done, where an option is added that there is not.
    words.push_back("--no-such-option");
    const auto done = test::slipstick(words);
    CHECK(done.status == 2);
    CHECK_THAT(done.err, Catch::Contains("The following argument was not expected: --no-such"));
  }
}
