// A print that is sliced as it goes is cut off, and taken up in the middle of a layer that is made
// again.
#include <catch2/catch.hpp>
#include <fstream>

#include "host/config.h"
#include "host/journalled_print.h"
#include "host/layer_lines.h"
#include "host/load_model.h"
#include "host/pause.h"
#include "sim/sim_transport.h"
#include "tests/support/cut_transport.h"
#include "tests/support/spiral.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

constexpr int kNever = test::CutTransport::kNever;
constexpr const char* kModel = "return difference(cylinder(5, 3), cylinder(2, 9))\n";

class LayerBench {
 public:
  LayerBench() {
    std::ofstream(model()) << kModel;
    settings_ = *load_settings({.overrides = {"certify=off", "layer_height=0.25",
                                              "first_layer_height=0.25", "sampling=0.25"}});
  }

  Result<StreamOutcome> start(int writes) {
    JournalledPrint print(journal(), {folder_.path().string(), {"print"}, 0, 0});
    return run(print, writes);
  }
  Result<StreamOutcome> resume() {
    JournalledPrint print(journal(), *read_journal(journal()), Consent::kNone);
    return run(print, kNever);
  }
  std::vector<test::Bead> beads() {
    sim_.run_down(std::chrono::hours(1));
    return beads_;
  }
  int layers_sliced() const { return layers_sliced_; }
  std::filesystem::path journal() const { return folder_.path() / "a.journal"; }

 private:
  std::filesystem::path model() const { return folder_.path() / "a.lua"; }

  Result<StreamOutcome> run(JournalledPrint& print, int writes) {
    test::CutTransport cable(sim_, writes);
    if (const auto ok = print.identify(model(), settings_); !ok) return fail(ok.error());
    if (const auto ok = print.find(cable, sim_.clock()); !ok) return fail(ok.error());
    const auto loaded = load_model(model(), {});
    REQUIRE(loaded);
    const auto placed = place_on_bed(*loaded->model, {}, {100, 100});
    REQUIRE(placed);
    SlicingRequest request;
    request.settings = settings_;
    request.threads = 1;
    const auto first = print.first_layer();
    if (first) request.first_layer = first->layer;
    const auto job = SlicingJob::start(*placed, request);
    REQUIRE(job);
    LayerLines layers(
        **job, settings_,
        [&](const SlicedLayer& layer) {
          ++layers_sliced_;
          print.began(layer.index, layer.program->text);
        },
        first ? LayerLines::Beginning::kLayer : LayerLines::Beginning::kStart);
    StreamOptions options{Pace::kVirtual, parking_place(settings_)};
    const auto lines = print.begin(layers, sim_.clock(), options);
    if (!lines) return fail(lines.error());
    const auto outcome = stream_job(cable, sim_.clock(), **lines, options);
    print.ended(outcome);
    return outcome;
  }

  test::TemporaryFolder folder_;
  PrintSettings settings_;
  std::vector<test::Bead> beads_;
  SimTransport sim_{*sim_options({}), test::into(beads_)};
  int layers_sliced_ = 0;
};

// The speed of a bead depends on what else was queued when it came.
std::vector<test::Bead> without_speed(std::vector<test::Bead> beads) {
  for (test::Bead& bead : beads) bead.back() = 0;
  return beads;
}

}  // namespace

TEST_CASE("A layer that was cut off is made again, and the print goes on in the middle of it") {
  LayerBench whole;
  REQUIRE(whole.start(kNever));
  const auto expected = without_speed(whole.beads());
  REQUIRE(whole.layers_sliced() == 12);
  REQUIRE(expected.size() > 300);

  int taken_up = 0;
  for (int cut = 20;; cut += 83) {
    INFO("cut off at write " << cut);
    LayerBench bench;
    if (bench.start(cut)) break;
    const auto outcome = bench.resume();
    INFO((outcome ? "" : outcome.error().message));
    REQUIRE(outcome);
    REQUIRE(without_speed(bench.beads()) == expected);
    CHECK(bench.layers_sliced() <= 12 + 2);
    ++taken_up;
  }
  CHECK(taken_up > 4);
}

TEST_CASE("A layer that is not what it was is not gone on with") {
  LayerBench bench;
  REQUIRE(!bench.start(400));
  auto content = *read_journal(bench.journal());
  std::string other =
      header_record(content.header) + session_record(content.session->first, content.session->base);
  for (const OtherLine& line : content.session->others) {
    other += other_record(line.number, line.text);
  }
  for (LayerMark mark : content.layers) {
    ++mark.program;
    other += layer_record(mark);
  }
  std::ofstream(bench.journal()) << other << taken_record(content.taken);

  const auto outcome = bench.resume();

  REQUIRE(!outcome);
  CHECK_THAT(outcome.error().message, Contains("would not be what it was"));
}
