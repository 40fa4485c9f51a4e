// docs/FAILURES.md names a test for each failure: the table and the tests may not part.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

constexpr int kCases = 112;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// The string literals behind `at`, joined: the compiler's view of a name on two lines.
std::string literal_at(const std::string& source, std::size_t at) {
  std::string name;
  while ((at = source.find_first_not_of(" \n", at)) != source.npos && source[at] == '"') {
    for (++at; at < source.size() && source[at] != '"'; ++at) {
      if (source[at] == '\\') ++at;
      name += source[at];
    }
    ++at;
  }
  return name;
}

void collect_names(const std::string& source, std::set<std::string>& names) {
  const std::string begin = "TEST_CASE(";
  for (std::size_t at = source.find(begin); at != source.npos; at = source.find(begin, at)) {
    at += begin.size();
    names.insert(literal_at(source, at));
  }
}

std::set<std::string> test_names() {
  std::set<std::string> names;
  const fs::path tests = fs::path(SLIPSTICK_SOURCE_DIR) / "tests";
  for (const auto& entry : fs::recursive_directory_iterator(tests)) {
    if (entry.path().extension() == ".cpp") collect_names(text_of(entry.path()), names);
  }
  return names;
}

// "| 7 | what | does | `test` |" to its cells; empty unless it is a row with a number.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' ');
    cells.push_back(
        begin == cell.npos ? "" : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
  }
  const bool numbered = cells.size() > 1 && !cells[1].empty() &&
                        std::ranges::all_of(cells[1], [](char c) { return c >= '0' && c <= '9'; });
  return numbered ? cells : std::vector<std::string>();
}

std::vector<std::string> quoted(const std::string& cell) {
  std::vector<std::string> names;
  std::istringstream stream(cell);
  for (std::string before, name;
       std::getline(stream, before, '`') && std::getline(stream, name, '`');)
    names.push_back(name);
  return names;
}

bool is_excused(const std::string& cell) {
  return cell.starts_with("**cannot arise**: ");
}

std::vector<std::string> faults_of(const std::string& table, const std::set<std::string>& tests) {
  std::vector<std::string> faults;
  std::map<int, int> seen;
  std::istringstream stream(table);
  for (std::string line; std::getline(stream, line);) {
    const auto cells = cells_of(line);
    if (cells.empty()) continue;
    ++seen[std::stoi(cells[1])];
    if (cells.size() < 5 || cells[2].empty() || cells[3].empty()) {
      faults.push_back(cells[1] + ": a cell is missing");
      continue;
    }
    const auto names = quoted(cells[4]);
    if (names.empty() && !is_excused(cells[3])) faults.push_back(cells[1] + ": no test, no reason");
    for (const std::string& name : names) {
      if (!tests.contains(name)) faults.push_back(cells[1] + ": no test is called '" + name + "'");
    }
  }
  for (int number = 1; number <= kCases; ++number) {
    if (seen[number] != 1) {
      faults.push_back(std::to_string(number) + ": " + std::to_string(seen[number]) + " times");
    }
  }
  if (seen.size() != kCases) faults.emplace_back("numbers beyond the last");
  return faults;
}

}  // namespace

TEST_CASE("Each of the 112 failures has a test that exists, or a reason why it has none") {
  const auto tests = test_names();
  REQUIRE(tests.size() > 300);
  for (const std::string& fault :
       faults_of(text_of(fs::path(SLIPSTICK_SOURCE_DIR) / "docs" / "FAILURES.md"), tests)) {
    FAIL_CHECK(fault);
  }
}

TEST_CASE("A failure without a test, with one that is not there, or told twice is noticed") {
  const std::set<std::string> tests{"It is found"};
  const auto faults = [&](const std::string& row) {
    return faults_of(row, tests).size() - (kCases - 1);  // the other numbers are missing
  };
  CHECK(faults("| 1 | what | deed | `It is found` |") == 0);
  CHECK(faults("| 1 | what | **cannot arise**: no card | |") == 0);
  CHECK(faults("| 1 | what | **open**: nobody has looked | |") == 1);
  CHECK(faults("| 1 | what | deed | |") == 1);
  CHECK(faults("| 1 | what | deed | `It is lost` |") == 1);
  CHECK(faults("| 1 | what | |") == 1);
  CHECK(faults("| 1 | a | b | `It is found` |\n| 1 | a | b | `It is found` |") == 1);
}

TEST_CASE("A test's name may go over two lines and hold quotes") {
  std::set<std::string> names;
  collect_names("TEST_CASE(\n    \"One \"\n    \"and two\") {}\nTEST_CASE(\"Th\\\"ree\", \"[x]\")",
                names);
  CHECK(names == std::set<std::string>{"One and two", "Th\"ree"});
}
