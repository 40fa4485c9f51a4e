#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "sim/byte_pipe.h"
#include "sim/line_reader.h"
#include "sim/rx_ring.h"

using namespace slipstick;

namespace {

std::string take_all(BytePipe& pipe, Moment by) {
  std::array<char, 4096> buffer{};
  return {buffer.data(), pipe.take(buffer, by)};
}

std::vector<std::string> lines_of(std::string_view bytes) {
  LineReader reader;
  std::vector<std::string> lines;
  for (const char byte : bytes) {
    if (const auto line = reader.feed(byte)) lines.emplace_back(*line);
  }
  return lines;
}

}  // namespace

TEST_CASE("A byte takes ten bits of the baud rate, one behind the other") {
  BytePipe pipe(100'000, FaultPlan(0, 1));  // 100 µs a byte.
  pipe.push("abc", Moment(1'000));

  CHECK(pipe.next_at() == Moment(1'100));
  CHECK(take_all(pipe, Moment(1'099)).empty());
  CHECK(take_all(pipe, Moment(1'200)) == "ab");
  CHECK(pipe.idle_at() == Moment(1'300));

  pipe.push("d", Moment(1'250));
  CHECK(take_all(pipe, Moment(1'399)) == "c");
  CHECK(take_all(pipe, Moment(1'400)) == "d");
  CHECK_FALSE(pipe.next_at());
}

TEST_CASE("At every moment that is announced a byte is there, at any rate") {
  for (const int baud : {9'600, 57'600, 115'200, 230'400, 250'000, 1'000'000}) {
    BytePipe pipe(baud, FaultPlan(0, 1));
    pipe.push(std::string(1'000, 'x'), Moment(123));
    while (const auto at = pipe.next_at()) REQUIRE_FALSE(take_all(pipe, *at).empty());
    CHECK(pipe.pending() == 0);
  }
}

TEST_CASE("Behind an adapter bytes are there when its timer ticks") {
  BytePipe pipe(100'000, FaultPlan(0, 1), Moment(16'000));
  pipe.push("abc", Moment(1'000));
  CHECK(pipe.next_at() == Moment(16'000));
  CHECK(take_all(pipe, Moment(15'999)).empty());
  CHECK(take_all(pipe, Moment(16'000)) == "abc");

  pipe.push("de", Moment(31'850));  // d is through at 31,950 and e at 32,050
  CHECK(pipe.next_at() == Moment(32'000));
  CHECK(take_all(pipe, Moment(40'000)) == "d");
  CHECK(pipe.next_at() == Moment(48'000));
}

TEST_CASE("At every tick that is announced a byte is there") {
  BytePipe pipe(100'000, FaultPlan(0, 1), Moment(16'000));
  for (int i = 0; i < 500; ++i) pipe.push("x", Moment(60'000 + 777 * i));
  while (const auto at = pipe.next_at()) REQUIRE_FALSE(take_all(pipe, *at).empty());
  CHECK(pipe.pending() == 0);
}

TEST_CASE("Native USB has no pace") {
  BytePipe pipe(0, FaultPlan(0, 1));

  pipe.push("abc", Moment(5));

  CHECK(take_all(pipe, Moment(5)) == "abc");
}

TEST_CASE("The share of bytes damaged is the one asked for") {
  FaultPlan faults(0.01, 5);
  for (int i = 0; i < 1'000; ++i) (void)faults.damaged(std::string(100, 'x'));

  // 1000 of 100,000 with a standard deviation of 31.5; six of them.
  CHECK(faults.count() == Approx(1'000).margin(190));
}

TEST_CASE("A wire without faults changes nothing, one of nothing but faults every byte") {
  CHECK(FaultPlan(0, 5).damaged("N1 M105*38\n") == "N1 M105*38\n");

  FaultPlan all(1, 5);
  (void)all.damaged(std::string(100, 'x'));
  CHECK(all.count() == 100);
}

TEST_CASE("The ring holds 127 bytes") {
  RxRing ring;
  for (int i = 0; i < 127; ++i) CHECK(ring.push(static_cast<char>(i)));

  CHECK_FALSE(ring.push('x'));
  CHECK(ring.pop() == '\0');
  CHECK(ring.push('x'));
}

TEST_CASE("Lines are cut as Marlin cuts them") {
  using Lines = std::vector<std::string>;
  CHECK(lines_of("a\nb\r\n\n\nc\n") == Lines{"a", "b", "c"});
  CHECK(lines_of("M105 ; why\n; nothing\n") == Lines{"M105 "});
  CHECK(lines_of("ax\bb\n") == Lines{"ab"});
  CHECK(lines_of("a\\;b\n") == Lines{"a;b"});
  CHECK(lines_of(std::string(95, 'x') + "\n") == Lines{std::string(95, 'x')});
  CHECK(lines_of(std::string(200, 'x') + "\n") == Lines{std::string(95, 'x')});
}
