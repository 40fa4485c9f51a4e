#pragma once

#include <catch2/catch.hpp>
#include <fstream>
#include <optional>

#include "host/config.h"
#include "host/journalled_print.h"
#include "host/layer_lines.h"
#include "host/load_model.h"
#include "host/pause.h"
#include "sim/sim_transport.h"
#include "tests/support/cut_transport.h"
#include "tests/support/spiral.h"
#include "tests/support/temporary_folder.h"

namespace slipstick::test {

/// A tube of twelve layers, sliced while it is printed on a simulated printer over a cable that may
/// break, with a journal; and somebody who changes its settings meanwhile.
class LayerBench {
 public:
  static constexpr int kNever = CutTransport::kNever;
  static constexpr int kLayers = 12;

  /// When layer `at` is about to be sent, or as soon as it may be, `values` are wished for.
  struct Wish {
    int at = 0;
    SettingTexts values;
  };

  explicit LayerBench(std::vector<Wish> wishes = {}) : wishes_(std::move(wishes)) {
    std::ofstream(model()) << "return difference(cylinder(5, 3), cylinder(2, 9))\n";
    settings_ = *load_settings({.overrides = {"certify=off", "layer_height=0.25",
                                              "first_layer_height=0.25", "sampling=0.25"}});
  }

  /// \param writes after which the cable breaks.
  Result<StreamOutcome> start(int writes) {
    JournalledPrint print(journal(), {folder_.path().string(), {"print"}, 0, 0});
    return run(print, writes);
  }
  Result<StreamOutcome> resume(int writes = kNever) {
    JournalledPrint print(journal(), *read_journal(journal()), Consent::kNone);
    return run(print, writes);
  }
  /// Prints it with changes that are known beforehand.
  Result<StreamOutcome> start_changed(const std::vector<SettingsChange>& changes) {
    promised_ = changes;
    return start(kNever);
  }

  std::vector<Bead> beads() {
    sim_.run_down(std::chrono::hours(1));
    return beads_;
  }
  int layers_sliced() const { return layers_sliced_; }
  std::filesystem::path journal() const { return folder_.path() / "a.journal"; }

  /// What somebody else has kept of the changes: all that were made, unless it is forgotten.
  const std::vector<SettingsChange>& promised() const { return promised_; }
  void forget_promised() { promised_.clear(); }

 private:
  std::filesystem::path model() const { return folder_.path() / "a.lua"; }

  void wish(SettingsTimeline& timeline, int layer) {
    while (granted_ < wishes_.size() && wishes_[granted_].at <= layer) {
      const auto from = timeline.change(wishes_[granted_].values);
      if (!from) return;
      REQUIRE(*from);
      promised_ = timeline.changes();
      ++granted_;
    }
  }

  Result<StreamOutcome> run(JournalledPrint& print, int writes) {
    CutTransport cable(sim_, writes);
    const auto timeline = std::make_shared<SettingsTimeline>(settings_);
    REQUIRE(timeline->take_up(promised_, 0));
    timeline->go_on();
    if (const auto ok = print.identify(model(), settings_); !ok) return fail(ok.error());
    if (const auto ok = print.keep(timeline); !ok) return fail(ok.error());
    if (const auto ok = print.find(cable, sim_.clock()); !ok) return fail(ok.error());
    const auto loaded = load_model(model(), {});
    REQUIRE(loaded);
    const auto placed = place_on_bed(*loaded->model, {}, {100, 100});
    REQUIRE(placed);
    SlicingRequest request;
    request.settings = settings_;
    request.threads = 1;
    request.timeline = timeline;
    const auto first = print.first_layer();
    if (first) request.first_layer = first->layer;
    const auto job = SlicingJob::start(*placed, request);
    REQUIRE(job);
    LayerLines layers(
        **job, settings_,
        [&](const SlicedLayer& layer) {
          ++layers_sliced_;
          print.began(layer.index, layer.program->text);
          wish(*timeline, layer.index);
        },
        first ? LayerLines::Beginning::kLayer : LayerLines::Beginning::kStart);
    StreamOptions options{Pace::kVirtual, parking_place(settings_)};
    const auto lines = print.begin(layers, sim_.clock(), options);
    if (!lines) return fail(lines.error());
    const auto outcome = stream_job(cable, sim_.clock(), **lines, options);
    print.ended(outcome);
    return outcome;
  }

  TemporaryFolder folder_;
  PrintSettings settings_;
  const std::vector<Wish> wishes_;
  std::size_t granted_ = 0;
  std::vector<SettingsChange> promised_;
  std::vector<Bead> beads_;
  SimTransport sim_{*sim_options({}), into(beads_)};
  int layers_sliced_ = 0;
};

}  // namespace slipstick::test
