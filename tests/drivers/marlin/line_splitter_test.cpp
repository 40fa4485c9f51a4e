#include "drivers/marlin/line_splitter.h"

#include <catch2/catch.hpp>
#include <vector>

namespace slipstick {
namespace {

std::vector<std::string> split(LineSplitter& splitter, std::string_view bytes) {
  std::vector<std::string> lines;
  splitter.feed(bytes);
  while (const auto line = splitter.next()) lines.emplace_back(*line);
  return lines;
}

using Lines = std::vector<std::string>;

TEST_CASE("Lines are the same in whatever pieces the bytes come") {
  const std::string bytes = "start\r\nok\n\n T:1 /0\rwait\n";
  LineSplitter whole;
  LineSplitter single;

  Lines lines;
  for (const char byte : bytes) {
    for (auto& line : split(single, {&byte, 1})) lines.push_back(line);
  }

  CHECK(split(whole, bytes) == Lines{"start", "ok", " T:1 /0", "wait"});
  CHECK(lines == Lines{"start", "ok", " T:1 /0", "wait"});
}

TEST_CASE("NULs vanish and an unfinished line waits") {
  LineSplitter splitter;
  using namespace std::string_view_literals;

  CHECK(split(splitter, "\0\0o\0k"sv).empty());
  CHECK(split(splitter, "\n"sv) == Lines{"ok"});
}

TEST_CASE("A line too long is dropped whole and counted, the next one is whole again") {
  LineSplitter splitter;
  const std::string longest(LineSplitter::kMaxLine, 'x');

  CHECK(split(splitter, longest + "\n") == Lines{longest});
  CHECK(split(splitter, longest + "xyz\nok\n") == Lines{"ok"});
  CHECK(splitter.overlong() == 1);
}

}  // namespace
}  // namespace slipstick
