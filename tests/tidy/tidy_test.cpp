// The rules of the house that a compiler does not know: who may include whom, how long files and
// lines may be, and that every test folder mirrors a source folder.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLinesMax = 400;

// core <- drivers <- sim <- host; tests see all.
const std::map<std::string, std::set<std::string>> kMayInclude{
    {"core", {"core", "hwy"}},  // Highway finds its sets of instructions through quoted includes
    {"drivers", {"core", "drivers"}},
    {"sim", {"core", "drivers", "sim"}},
    {"host", {"core", "drivers", "sim", "host"}},
};

std::string first_folder(const std::string& path) {
  return path.substr(0, path.find('/'));
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The path in `#include "path"`, or nothing.
std::string included(const std::string& line) {
  const std::string start = "#include \"";
  if (line.rfind(start, 0) != 0) return {};
  return line.substr(start.size(), line.rfind('"') - start.size());
}

std::vector<std::string> faults_of(const std::string& name, const std::vector<std::string>& lines) {
  std::vector<std::string> faults;
  if (lines.size() > kLinesMax) faults.push_back(name + ": longer than 400 lines");
  const auto allowed = kMayInclude.find(first_folder(name));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string where = name + ":" + std::to_string(i + 1) + ": ";
    const std::string path = included(lines[i]);
    if (path.empty() || allowed == kMayInclude.end()) continue;
    if (!allowed->second.contains(first_folder(path))) {
      faults.push_back(where + first_folder(name) + " must not include " + path);
    }
  }
  return faults;
}

std::vector<std::string> faults_of_tree(const fs::path& root) {
  std::vector<std::string> faults;
  std::size_t files = 0;
  for (const char* folder : {"core", "drivers", "sim", "host", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const auto extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      ++files;
      const std::string name = fs::relative(entry.path(), root).generic_string();
      for (auto& fault : faults_of(name, lines_of(entry.path()))) faults.push_back(fault);
    }
  }
  REQUIRE(files > 50);
  return faults;
}

}  // namespace

TEST_CASE("The tree keeps the rules of the house") {
  for (const std::string& fault : faults_of_tree(SLIPSTICK_SOURCE_DIR)) FAIL_CHECK(fault);
}

TEST_CASE("An include upwards is a fault, one downwards is not") {
  CHECK(faults_of("core/a.h", {"#include \"drivers/b.h\""}).size() == 1);
  CHECK(faults_of("drivers/a.h", {"#include \"host/b.h\""}).size() == 1);
  CHECK(faults_of("sim/a.h", {"#include \"core/b.h\"", "#include \"drivers/c.h\""}).empty());
  CHECK(faults_of("tests/a.cpp", {"#include \"host/b.h\""}).empty());
}

// Two headers that define a type of one name would each be right alone; linked together the program
// breaks in places far away (one definition rule).
TEST_CASE("No type name is defined in two headers") {
  const std::regex definition(R"(^(struct|class|enum class) (\w+)( final)?( :[^;]*)?( \{.*)?$)");
  std::map<std::string, std::string> home;
  for (const char* folder : {"core", "drivers", "sim", "host"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(SLIPSTICK_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".h") continue;
      for (const std::string& line : lines_of(entry.path())) {
        std::smatch match;
        if (!std::regex_match(line, match, definition)) continue;
        const auto [at, is_new] = home.emplace(match[2], entry.path().string());
        if (!is_new) FAIL_CHECK(match[2] << " in " << entry.path() << " and " << at->second);
      }
    }
  }
  CHECK(home.size() > 100);
}

TEST_CASE("A file of 401 lines is too long") {
  CHECK(faults_of("core/a.cpp", std::vector<std::string>(400)).empty());
  CHECK(faults_of("core/a.cpp", std::vector<std::string>(401)).size() == 1);
}

TEST_CASE("The top level is what was agreed") {
  const std::set<std::string> folders{"host",    "core", "drivers", "sim",   "tests",
                                      "configs", "docs", "scripts", "build", "demo-out"};
  for (const auto& entry : fs::directory_iterator(SLIPSTICK_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name[0] != '.') CHECK(folders.contains(name));
  }
}
