// Deterministic simulation: whole prints with every fault there is, each drawn from one number.
//
// SLIPSTICK_SEEDS=N runs N of them instead of the few that every build can afford; SLIPSTICK_SEED=S
// runs number S alone, which is what a failure prints.
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

void check_law(std::uint64_t seed, Tally& tally) {
  const VoyagePlan plan = draw_plan(seed);
  PlannedVoyage sailed(plan, seed);
  const SenderState end = sailed.run();
  Voyage& voyage = sailed.voyage();
  const auto executed = without_repeats(sailed.executed());
  INFO("replay with SLIPSTICK_SEED="
       << seed << ": state " << static_cast<int>(end) << ", " << voyage.sender().reason()
       << "; mishap " << static_cast<int>(plan.mishap.kind) << "; " << executed.size() << " of "
       << plan.job.size() << " lines executed");
  const auto [wrong, planned] = std::ranges::mismatch(executed, plan.job);
  INFO("executed '" << (wrong == executed.end() ? "" : *wrong) << "' for '"
                    << (planned == plan.job.end() ? "" : *planned) << "'");
  const bool cancelled = !sailed.can_finish() && plan.mishap.kind == Mishap::Kind::kCancel;

  REQUIRE(is_prefix(executed, plan.job));
  if (end == SenderState::kDone) {
    if (!cancelled) REQUIRE(executed.size() == plan.job.size());
  } else {
    REQUIRE((end == SenderState::kLost || end == SenderState::kHalted));
    REQUIRE_FALSE(voyage.sender().reason().empty());
  }
  const bool stopped = end != SenderState::kDone || cancelled;
  const bool reachable = !voyage.unplugged() && plan.mishap.kind != Mishap::Kind::kFreeze;
  if (stopped && reachable) REQUIRE_FALSE(voyage.printer().heats());

  tally.could_finish += sailed.can_finish() ? 1U : 0U;
  tally.finished += sailed.can_finish() && end == SenderState::kDone ? 1U : 0U;
  tally.faults += voyage.faults();
  tally.ghosts += voyage.sender().counters().ghosts;
  tally.undetected += voyage.printer().undetected();
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
  const auto executed = without_repeats(sailed.executed());
  const bool cancelled = !sailed.can_finish() && plan.mishap.kind == Mishap::Kind::kCancel;
  INFO("replay with SLIPSTICK_SEED=" << seed << ": state " << static_cast<int>(end) << ", "
                                     << sailed.voyage().sender().reason() << "; " << executed.size()
                                     << " of " << plan.job.size());
  const auto [wrong, planned] = std::ranges::mismatch(executed, plan.job);
  INFO("executed '" << (wrong == executed.end() ? "" : *wrong) << "' for '"
                    << (planned == plan.job.end() ? "" : *planned) << "'");

  if (end == SenderState::kDone) {
    REQUIRE(is_prefix(executed, plan.job));
    if (!cancelled) REQUIRE(executed.size() == plan.job.size());
  } else {
    REQUIRE((end == SenderState::kLost || end == SenderState::kHalted));
    REQUIRE_FALSE(sailed.voyage().sender().reason().empty());
    REQUIRE(executed.end() - wrong <= Sender::kWindowLines);
  }
  tally.could_finish += sailed.can_finish() ? 1U : 0U;
  tally.finished += sailed.can_finish() && end == SenderState::kDone ? 1U : 0U;
  tally.behind += sailed.voyage().sender().counters().lines_behind;
  tally.lines += sailed.voyage().sender().counters().lines_sent;
  tally.faults += sailed.voyage().faults();
  tally.ghosts += sailed.voyage().sender().counters().ghosts;
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
