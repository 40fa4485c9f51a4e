// Deterministic simulation: whole prints with every fault there is, each drawn from one number.
//
// SLIPSTICK_SEEDS=N runs N of them instead of the few that every build can afford; SLIPSTICK_SEED=S
// runs number S alone, which is what a failure prints.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "drivers/marlin/repeatable.h"
#include "tests/support/voyage_plan.h"

namespace slipstick {
namespace {

constexpr std::uint64_t kSeeds = 2000;

std::optional<std::uint64_t> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? std::nullopt : std::optional(std::strtoull(text, nullptr, 10));
}

bool is_prefix(const std::vector<std::string>& begin, const std::vector<std::string>& whole) {
  return begin.size() <= whole.size() && std::equal(begin.begin(), begin.end(), whole.begin());
}

/// Tails of damaged lines may give a setting twice; a move they may not.
std::vector<std::string> without_repeats(std::vector<std::string> lines) {
  const auto same = [](const std::string& a, const std::string& b) {
    return a == b && is_repeatable(a);
  };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  return lines;
}

struct Tally {
  std::uint64_t could_finish = 0;
  std::uint64_t finished = 0;
  std::uint64_t faults = 0;
  std::uint64_t undetected = 0;
  std::uint64_t ghosts = 0;
  std::uint64_t behind = 0;
  std::uint64_t lines = 0;
};

/// What happened, for a failure.
std::string told(std::uint64_t seed, const VoyagePlan& plan, PlannedVoyage& sailed) {
  const auto executed = without_repeats(sailed.executed());
  const auto [wrong, planned] = std::ranges::mismatch(executed, plan.job);
  const Sender& sender = sailed.voyage().sender();
  return fmt::format(
      "replay with SLIPSTICK_SEED={}: state {}, {}; mishap {}; {} of {} lines executed, '{}' for "
      "'{}'",
      seed, static_cast<int>(sender.state()), sender.reason(), static_cast<int>(plan.mishap.kind),
      executed.size(), plan.job.size(), wrong == executed.end() ? "" : *wrong,
      planned == plan.job.end() ? "" : *planned);
}

bool was_cancelled(const VoyagePlan& plan, const PlannedVoyage& sailed) {
  return !sailed.can_finish() && plan.mishap.kind == Mishap::Kind::kCancel;
}

/// A print that is done is whole, and one that is not says why.
void check_end(const VoyagePlan& plan, PlannedVoyage& sailed, SenderState end) {
  const auto executed = without_repeats(sailed.executed());
  const bool whole = was_cancelled(plan, sailed) || executed.size() == plan.job.size();
  const bool done = end == SenderState::kDone && is_prefix(executed, plan.job) && whole;
  const bool stopped = end == SenderState::kLost || end == SenderState::kHalted;
  REQUIRE((done || (stopped && !sailed.voyage().sender().reason().empty())));
}

void count(PlannedVoyage& sailed, SenderState end, Tally& tally) {
  Voyage& voyage = sailed.voyage();
  const SenderCounters& counters = voyage.sender().counters();
  tally.could_finish += sailed.can_finish() ? 1U : 0U;
  tally.finished += sailed.can_finish() && end == SenderState::kDone ? 1U : 0U;
  tally.faults += voyage.faults();
  tally.ghosts += counters.ghosts;
  tally.undetected += voyage.printer().undetected();
  tally.behind += counters.lines_behind;
  tally.lines += counters.lines_sent;
}

void check_law(std::uint64_t seed, Tally& tally) {
  const VoyagePlan plan = draw_plan(seed);
  PlannedVoyage sailed(plan, seed);
  const SenderState end = sailed.run();
  INFO(told(seed, plan, sailed));
  REQUIRE(is_prefix(without_repeats(sailed.executed()), plan.job));
  check_end(plan, sailed, end);
  const bool stopped = end != SenderState::kDone || was_cancelled(plan, sailed);
  const bool reachable = !sailed.voyage().unplugged() && plan.mishap.kind != Mishap::Kind::kFreeze;
  if (stopped && reachable) REQUIRE_FALSE(sailed.voyage().printer().heats());
  count(sailed, end, tally);
}

TEST_CASE("Whatever happens, the job is executed once and in order, or its beginning and no heat") {
  Tally tally;
  if (const auto seed = number_in("SLIPSTICK_SEED")) return check_law(*seed, tally);
  const std::uint64_t seeds = number_in("SLIPSTICK_SEEDS").value_or(kSeeds);

  for (std::uint64_t seed = 1; seed <= seeds; ++seed) check_law(seed, tally);

  // Otherwise this test tests nothing.
  CHECK(tally.faults > 10 * seeds);
  CHECK(tally.could_finish > seeds / 2);
  CHECK(tally.undetected > 0);
  CHECK(tally.ghosts > 0);
  // Giving up is lawful, but not what a sender is for.
  CHECK(tally.finished >= tally.could_finish - tally.could_finish / 1000);
}

/// With several lines under way, what a board obeys of those behind a damaged one comes before it.
/// Then the print is not whole, and ends; no more than a window of them.
void check_window_law(std::uint64_t seed, Tally& tally) {
  VoyagePlan plan = draw_plan(seed);
  Rng rng(seed ^ 0x817D0B);
  plan.options.sender.window = 40 + static_cast<int>(rng.below(81));
  plan.options.sender.proving = static_cast<int>(rng.below(10));
  plan.options.down.damage /= 4;
  plan.options.up.damage /= 4;
  PlannedVoyage sailed(plan, seed);
  const SenderState end = sailed.run();
  INFO(told(seed, plan, sailed));
  check_end(plan, sailed, end);
  const auto executed = without_repeats(sailed.executed());
  const auto wrong = std::ranges::mismatch(executed, plan.job).in1;
  REQUIRE(executed.end() - wrong <= Sender::kWindowLines);
  count(sailed, end, tally);
}

TEST_CASE("With a window too a print that is done is whole, and one that is not says so") {
  Tally tally;
  if (const auto seed = number_in("SLIPSTICK_SEED")) return check_window_law(*seed, tally);
  const std::uint64_t seeds = number_in("SLIPSTICK_SEEDS").value_or(kSeeds);

  for (std::uint64_t seed = 1; seed <= seeds; ++seed) check_window_law(seed, tally);

  CHECK(tally.faults > seeds);
  CHECK(tally.could_finish > seeds / 2);
  CHECK(tally.ghosts > 0);
  CHECK(tally.finished >= tally.could_finish - tally.could_finish / 50);
  CHECK(tally.behind > tally.lines / 4);
}

}  // namespace
}  // namespace slipstick
