#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "tests/support/marlin_model_voyage.h"

namespace slipstick {
namespace {

/// Relative extrusions, where a line executed twice would matter; homing and a wait now and then.
std::vector<std::string> make_job(std::size_t lines) {
  std::vector<std::string> job{"G28", "M83"};
  for (std::size_t i = job.size(); i < lines; ++i) {
    job.push_back(i % 90 == 0
                      ? fmt::format("G4 P{}", i)
                      : fmt::format("G1 X{}.{} Y{} E.0{}", i % 200, i % 10, i * 7 % 180, i));
  }
  return job;
}

TEST_CASE("A job crosses a faultless wire without a single line sent again") {
  Voyage voyage({}, 1);
  const auto job = make_job(300);

  REQUIRE(voyage.print(job) == SenderState::kDone);

  CHECK(job_lines(voyage.printer().executed()) == job);
  CHECK(voyage.sender().counters().lines_acknowledged == job.size());
  CHECK(voyage.sender().counters().lines_sent == job.size());
  CHECK(voyage.sender().counters().resends == 0);
  CHECK(voyage.sender().counters().probes == 0);
}

TEST_CASE("One byte in a hundred damaged both ways is still a print") {
  const auto job = make_job(200);

  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    INFO("seed " << seed);
    Voyage voyage({.down = {.damage = 1e-2}, .up = {.damage = 1e-2, .lost_oks = 0.02}}, seed);
    const SenderState end = voyage.print(job);
    INFO(voyage.sender().reason());
    REQUIRE(end == SenderState::kDone);
    REQUIRE(job_lines(voyage.printer().executed()) == job);
  }
}

TEST_CASE("Known hazard: damage the XOR cannot see, or that strips a number, is obeyed") {
  const auto job = make_job(200);
  std::uint64_t undetected = 0;

  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Voyage voyage({.printer = {.undetected = Undetected::kObey}, .down = {.damage = 1e-2}}, seed);
    (void)voyage.print(job);
    if (voyage.printer().undetected() > 0) ++undetected;
    // Nothing but those lines may differ.
    if (voyage.printer().undetected() == 0) {
      INFO("seed " << seed);
      REQUIRE(job_lines(voyage.printer().executed()) == job);
    }
  }

  CHECK(undetected > 0);
}

TEST_CASE("After a reset nothing more is executed, heard or unheard its start") {
  const auto job = make_job(400);

  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    INFO("seed " << seed);
    Voyage voyage({}, seed);
    while (voyage.sender().state() == SenderState::kGreeting) voyage.take_turn();
    std::size_t pushed = 0;
    const std::size_t reset_after = 1 + seed;
    while (job_lines(voyage.printer().executed()).size() < reset_after) {
      if (voyage.sender().wants_line()) voyage.sender().push(*Line::make(job[pushed++]));
      voyage.take_turn();
    }
    voyage.printer().reset(voyage.now());
    if (seed % 2 == 0) voyage.lose_replies();
    const std::size_t before = job_lines(voyage.printer().executed()).size();

    const auto rest = std::vector(job.begin() + static_cast<std::ptrdiff_t>(pushed), job.end());
    REQUIRE(voyage.print(rest) == SenderState::kLost);
    REQUIRE(job_lines(voyage.printer().executed()).size() == before);
  }
}

}  // namespace
}  // namespace slipstick
