#include "host/settings_timeline.h"

#include <fmt/format.h>

#include <algorithm>

namespace slipstick {

SettingsTimeline::SettingsTimeline(const PrintSettings& settings)
    : original_(std::make_shared<const PrintSettings>(settings)) {}

SettingsTimeline::OfLayer SettingsTimeline::begin(int layer) {
  const std::lock_guard lock(mutex_);
  begun_ = std::max(begun_, layer + 1);
  State own = at(layer);
  return {own.settings, layer == 0 ? original_ : at(layer - 1).settings, std::move(own.cancelled)};
}

void SettingsTimeline::end_at(int layer) {
  const std::lock_guard lock(mutex_);
  end_ = layer;
}

Result<std::optional<int>> SettingsTimeline::change(const SettingTexts& values) {
  const std::lock_guard lock(mutex_);
  const Change* const last = changes_.empty() ? nullptr : &changes_.back();
  auto state = after(last == nullptr ? State{original_, {}} : last->after, values);
  if (!state) return fail(state.error());
  if (taken_up_) {
    return fail(ErrorCode::kUnavailable, "the print is being taken up; try again when it goes on");
  }
  if (changes_.size() >= kChangesMax) {
    return fail(ErrorCode::kUnavailable,
                fmt::format("the settings of this print were changed {} times and change no more",
                            kChangesMax));
  }
  const int from = std::max(begun_, last == nullptr ? 0 : last->what.from_layer);
  if (end_ && from >= *end_) return std::optional<int>();
  changes_.push_back({{from, values}, *std::move(state)});
  return std::optional(from);
}

std::vector<SettingsChange> SettingsTimeline::changes() const {
  const std::lock_guard lock(mutex_);
  std::vector<SettingsChange> all;
  for (const Change& change : changes_) all.push_back(change.what);
  return all;
}

Result<void> SettingsTimeline::take_up(const std::vector<SettingsChange>& told, int begun) {
  auto replay = replayed(told);
  if (!replay) return fail(replay.error());
  const std::lock_guard lock(mutex_);
  taken_up_ = true;
  begun_ = std::max(begun_, begun);
  const auto same = [](const SettingsChange& a, const Change& b) { return a == b.what; };
  const bool known = changes_.size() >= told.size() &&
                     std::equal(told.begin(), told.end(), changes_.begin(), same);
  // What was printed is what the journal says.
  if (!known) changes_ = *std::move(replay);
  return {};
}

void SettingsTimeline::go_on() {
  const std::lock_guard lock(mutex_);
  taken_up_ = false;
}

int SettingsTimeline::bottom_layers_from(int layer) const {
  const std::lock_guard lock(mutex_);
  int most = at(layer).settings->toolpath.bottom_layers;
  for (const Change& change : changes_) {
    if (change.what.from_layer > layer)
      most = std::max(most, change.after.settings->toolpath.bottom_layers);
  }
  return most;
}

Result<SettingsTimeline::Changes> SettingsTimeline::replayed(
    const std::vector<SettingsChange>& told) const {
  if (told.size() > kChangesMax) return fail(ErrorCode::kInput, "too many changes of settings");
  Changes changes;
  for (const SettingsChange& change : told) {
    auto state =
        after(changes.empty() ? State{original_, {}} : changes.back().after, change.values);
    if (!state) return fail(state.error());
    if (!changes.empty() && change.from_layer < changes.back().what.from_layer)
      return fail(ErrorCode::kInput, "changes of settings are out of order");
    changes.push_back({change, *std::move(state)});
  }
  return changes;
}

// \pre The lock is held.
SettingsTimeline::State SettingsTimeline::at(int layer) const {
  const auto beyond = std::ranges::upper_bound(
      changes_, layer, {}, [](const Change& change) { return change.what.from_layer; });
  return beyond == changes_.begin() ? State{original_, {}} : (beyond - 1)->after;
}

Result<SettingsTimeline::State> SettingsTimeline::after(State state, SettingTexts values) {
  if (const auto object = values.find(kCancelObject); object != values.end()) {
    const auto cancelled = parse_cancelled_object(object->second);
    if (!cancelled) return fail(ErrorCode::kInput, "cancel_object: must be LAYER X Y");
    state.cancelled.push_back(*cancelled);
    values.erase(object);
    if (values.empty()) return state;
  }
  auto settings = changed(*state.settings, values);
  if (!settings) return fail(settings.error());
  state.settings = std::make_shared<const PrintSettings>(*std::move(settings));
  return state;
}

}  // namespace slipstick
