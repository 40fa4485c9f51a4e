// Settings that change while layers are made: who has which, whatever the threads do.
#include "host/settings_timeline.h"

#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "core/formats/lua_script.h"
#include "core/job/placement.h"
#include "host/slicing_job.h"

using namespace slipstick;

namespace {

PrintSettings coarse() {
  PrintSettings settings;
  settings.slicing.certify = Certification::kOff;
  settings.slicing.sampling = 0.3;
  settings.slicing.layer_height = settings.slicing.first_layer_height = 0.3;
  settings.toolpath.top_layers = settings.toolpath.bottom_layers = 2;
  return settings;
}

// Steps: what is above and below a layer matters to its skins.
constexpr const char* kModel =
    "return union(cylinder(6, 4), box(7, 7, 4):move(0, 0, 4), cylinder(3, 6):move(0, 0, 8))\n";

PlacedSolid placed() {
  const auto model = load_lua_model(kModel, "steps.lua");
  REQUIRE(model);
  return *place_on_bed(**model, {}, {60, 60});
}

using Texts = std::vector<std::string>;
using Timeline = std::shared_ptr<SettingsTimeline>;

std::unique_ptr<SlicingJob> job_of(const Timeline& timeline, int threads) {
  SlicingRequest request;
  request.settings = timeline->original();
  request.threads = threads;
  request.timeline = timeline;
  auto job = SlicingJob::start(placed(), request);
  REQUIRE(job);
  return *std::move(job);
}

// `before(layer)` is called before each is taken.
template <typename Before>
Texts programs(SlicingJob& job, Before before) {
  Texts texts;
  while (true) {
    before(static_cast<int>(texts.size()));
    const auto layer = job.next();
    REQUIRE(layer);
    if (!*layer) return texts;
    texts.push_back((*layer)->program->text);
  }
}

Texts programs_of(const PrintSettings& settings) {
  const auto job = job_of(std::make_shared<SettingsTimeline>(settings), 2);
  return programs(*job, [](int) {});
}

// Without what is said when settings change.
std::string body(const std::string& text) {
  return text.substr(text.find("G0 Z"));
}

// Each layer is that of a print which had its settings from the beginning.
void check(const Texts& texts, const std::vector<SettingsChange>& changes) {
  PrintSettings settings = coarse();
  Texts whole = programs_of(settings);
  REQUIRE(texts.size() == whole.size());
  std::size_t due = 0;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const std::size_t old = due;
    for (; due < changes.size() && changes[due].from_layer == static_cast<int>(k); ++due)
      settings = *changed(settings, changes[due].values);
    INFO("layer " << k);
    if (due == old) {
      REQUIRE(texts[k] == whole[k]);
    } else {
      whole = programs_of(settings);
      REQUIRE(body(texts[k]) == body(whole[k]));
    }
  }
  CHECK(due == changes.size());
}

const std::vector<SettingTexts> kWishes{{{"infill_density", "0.6"}},
                                        {{"bottom_layers", "9"}, {"top_layers", "1"}},
                                        {{"retraction", "2.5"}, {"fan", "0.3"}, {"flow", "0.9"}},
                                        {{"perimeters", "1"}, {"line_width", "0.5"}},
                                        {{"outer_perimeter_speed", "15"}}};

}  // namespace

TEST_CASE("threads: layers below a change are those of the old settings, the others of the new") {
  Rng rng(7);
  for (const int threads : {1, 2, 5}) {
    const auto timeline = std::make_shared<SettingsTimeline>(coarse());
    const auto job = job_of(timeline, threads);
    std::vector<int> told;
    const auto wish = [&](int layer) {
      if (layer == 0 || rng.below(6) != 0) return;
      const auto from = timeline->change(kWishes[rng.below(kWishes.size())]);
      REQUIRE(from);
      if (!*from) return;
      CHECK(**from >= layer);
      CHECK(**from <= layer + threads + 2);
      told.push_back(**from);
    };

    const Texts texts = programs(*job, wish);

    const auto changes = timeline->changes();
    REQUIRE(told.size() == changes.size());
    for (std::size_t i = 0; i < told.size(); ++i) CHECK(told[i] == changes[i].from_layer);
    REQUIRE(changes.size() > 2);
    check(texts, changes);
  }
}

TEST_CASE("A print with changes that are known beforehand is the one in which they were made") {
  const auto live = std::make_shared<SettingsTimeline>(coarse());
  const auto job = job_of(live, 1);
  const Texts texts = programs(*job, [&](int layer) {
    if (layer == 5 || layer == 20) REQUIRE(live->change(kWishes[layer == 5 ? 2 : 1]));
  });

  const auto again = std::make_shared<SettingsTimeline>(coarse());
  REQUIRE(again->take_up(live->changes(), 0));
  const auto second = job_of(again, 4);

  CHECK(programs(*second, [](int) {}) == texts);
}

TEST_CASE("A change holds from the first layer that nobody has begun, and is told as it was") {
  SettingsTimeline timeline(coarse());
  const auto fourth = timeline.begin(3);

  const auto from = timeline.change({{"perimeters", "5"}});

  REQUIRE(from);
  CHECK(*from == 4);
  CHECK(timeline.begin(2).own->toolpath.perimeters == 2);
  CHECK(fourth.own->toolpath.perimeters == 2);
  CHECK(timeline.begin(4).own->toolpath.perimeters == 5);
  CHECK(timeline.begin(4).below->toolpath.perimeters == 2);
  CHECK(timeline.begin(5).below->toolpath.perimeters == 5);
  CHECK(timeline.changes() == std::vector<SettingsChange>{{4, {{"perimeters", "5"}}}});
}

TEST_CASE("Changes before the same layer add up, and the last word counts") {
  SettingsTimeline timeline(coarse());

  REQUIRE(timeline.change({{"perimeters", "5"}, {"fan", "0.2"}}));
  REQUIRE(timeline.change({{"perimeters", "3"}}));

  const auto first = timeline.begin(0);
  CHECK(first.own->toolpath.perimeters == 3);
  CHECK(first.own->material.fan == 0.2);
  CHECK(first.below->toolpath.perimeters == 2);
  CHECK(timeline.changes().size() == 2);
}

TEST_CASE("Where no layer is left nothing changes") {
  SettingsTimeline timeline(coarse());
  timeline.end_at(10);
  static_cast<void>(timeline.begin(9));

  const auto from = timeline.change({{"perimeters", "5"}});

  REQUIRE(from);
  CHECK(*from == std::nullopt);
  CHECK(timeline.changes().empty());
}

TEST_CASE("A change that is refused changes nothing") {
  SettingsTimeline timeline(coarse());

  CHECK(!timeline.change({{"perimeters", "5"}, {"sampling", "0.2"}}));

  CHECK(timeline.changes().empty());
  CHECK(timeline.begin(0).own->toolpath.perimeters == 2);
}

TEST_CASE("So many changes are taken and no more") {
  SettingsTimeline timeline(coarse());
  for (std::size_t i = 0; i < SettingsTimeline::kChangesMax; ++i)
    REQUIRE(timeline.change({{"perimeters", "5"}}));

  const auto refused = timeline.change({{"perimeters", "5"}});

  REQUIRE(!refused);
  CHECK(refused.error().code == ErrorCode::kUnavailable);
}

TEST_CASE("While a print is being taken up nothing changes, and later nothing that was printed") {
  SettingsTimeline timeline(coarse());
  const std::vector<SettingsChange> told{{3, {{"perimeters", "5"}}}};
  REQUIRE(timeline.take_up(told, 8));

  const auto refused = timeline.change({{"perimeters", "4"}});
  timeline.go_on();

  REQUIRE(!refused);
  CHECK(refused.error().code == ErrorCode::kUnavailable);
  CHECK(*timeline.change({{"perimeters", "4"}}) == 8);
  CHECK(timeline.begin(2).own->toolpath.perimeters == 2);
  CHECK(timeline.begin(7).own->toolpath.perimeters == 5);
}

TEST_CASE("What a journal tells counts; what was promised for later layers stays") {
  const SettingsChange first{3, {{"perimeters", "5"}}}, second{9, {{"fan", "0.5"}}};
  const SettingsChange other{3, {{"perimeters", "4"}}};
  SettingsTimeline more(coarse()), less(coarse()), different(coarse());
  REQUIRE(more.take_up({first, second}, 0));
  REQUIRE(different.take_up({other, second}, 0));

  for (SettingsTimeline* timeline : {&more, &less, &different})
    REQUIRE(timeline->take_up({first}, 4));

  CHECK(more.changes() == std::vector<SettingsChange>{first, second});
  CHECK(less.changes() == std::vector<SettingsChange>{first});
  CHECK(different.changes() == std::vector<SettingsChange>{first});
}

TEST_CASE("Changes that cannot have been made are not taken up") {
  SettingsTimeline timeline(coarse());

  CHECK(!timeline.take_up({{3, {{"sampling", "0.2"}}}}, 0));
  CHECK(!timeline.take_up({{3, {{"fan", "1"}}}, {2, {{"fan", "0"}}}}, 0));
  CHECK(timeline.changes().empty());
}
