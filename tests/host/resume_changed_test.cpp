// A print whose settings were changed as it went is cut off, and taken up with the same settings.
#include <catch2/catch.hpp>
#include <deque>

#include "tests/host/layer_bench.h"

using namespace slipstick;
using test::LayerBench;

namespace {

const std::vector<LayerBench::Wish> kWishes{
    {2, {{"infill_density", "0.5"}, {"nozzle_celsius", "220"}}},
    {3, {{"retraction", "2"}, {"perimeters", "1"}, {"fan", "0.4"}}},
    {6, {{"flow", "0.8"}, {"bottom_layers", "6"}, {"outer_perimeter_speed", "20"}}}};

std::vector<test::Bead> without_speed(std::vector<test::Bead> beads) {
  for (test::Bead& bead : beads) bead.back() = 0;
  return beads;
}

// What a print lays that has these changes from the beginning; each is printed once.
class Expected {
 public:
  const std::vector<test::Bead>& of(const std::vector<SettingsChange>& changes) {
    for (const auto& [known, beads] : known_) {
      if (known == changes) return beads;
    }
    LayerBench bench;
    REQUIRE(bench.start_changed(changes));
    known_.emplace_back(changes, without_speed(bench.beads()));
    return known_.back().second;
  }

 private:
  std::deque<std::pair<std::vector<SettingsChange>, std::vector<test::Bead>>> known_;
};

enum class Database { kThere, kLost };

// Cuts prints off at every so many writes, and whoever takes them up a second time.
int check_cuts(int first, int step, Database database) {
  Expected expected;
  int taken_up = 0;
  for (int cut = first;; cut += step) {
    INFO("cut off at write " << cut);
    LayerBench bench(kWishes);
    if (bench.start(cut)) return taken_up;
    if (database == Database::kLost) bench.forget_promised();
    const auto again = bench.resume(step * 3);
    if (!again) {
      if (database == Database::kLost) bench.forget_promised();
      const auto outcome = bench.resume();
      INFO((outcome ? "" : outcome.error().message));
      REQUIRE(outcome);
    }
    const auto told = read_journal(bench.journal());
    REQUIRE(told);
    REQUIRE(without_speed(bench.beads()) == expected.of(told->changes));
    if (database == Database::kThere) {
      CHECK(told->changes == bench.promised());
      CHECK(told->changes.size() == kWishes.size());
    }
    ++taken_up;
  }
}

}  // namespace

TEST_CASE("Changed settings are those of the layers that are laid") {
  LayerBench bench(kWishes), plain;
  REQUIRE(bench.start(LayerBench::kNever));
  REQUIRE(plain.start(LayerBench::kNever));
  REQUIRE(bench.promised().size() == kWishes.size());

  const auto laid = without_speed(bench.beads());

  CHECK(laid == Expected().of(bench.promised()));
  CHECK(laid != without_speed(plain.beads()));
}

TEST_CASE("A print whose settings were changed is taken up with them, wherever it was cut off") {
  CHECK(check_cuts(20, 61, Database::kThere) > 4);
}

TEST_CASE("The journal alone tells the settings of all that was begun") {
  CHECK(check_cuts(33, 97, Database::kLost) > 3);
}

TEST_CASE("A change that no layer had before the print was cut off is still done") {
  const std::vector<LayerBench::Wish> wish{{5, {{"infill_density", "0.5"}}}};
  std::optional<LayerBench> bench;
  // As soon as it is promised: its first layer is not sent yet.
  for (int cut = 20; !bench || bench->promised().empty(); cut += 7) {
    bench.emplace(wish);
    REQUIRE(!bench->start(cut));
  }
  REQUIRE(read_journal(bench->journal())->changes.empty());

  REQUIRE(bench->resume());

  CHECK(without_speed(bench->beads()) == Expected().of(bench->promised()));
  CHECK(read_journal(bench->journal())->changes == bench->promised());
}
