#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/job/settings_change.h"
#include "host/cancelled_object.h"

namespace slipstick {

/// The settings of each layer of a print. They may change for the layers that nobody has begun to
/// make; all others keep what they have, whichever thread makes them and whenever.
///
/// Threads: any thread may call anything at any time.
class SettingsTimeline {
 public:
  static constexpr std::size_t kChangesMax = 256;

  using Settings = std::shared_ptr<const PrintSettings>;
  struct OfLayer {
    Settings own;
    Settings below;  ///< Of the layer below it; of the first, those that the print began with.
    std::vector<CancelledObject> cancelled;  ///< What it is made without, in order.
  };

  explicit SettingsTimeline(const PrintSettings& settings);

  /// Those that the print began with.
  [[nodiscard]] const PrintSettings& original() const { return *original_; }

  /// `layer` is about to be made: nothing changes up to it any more.
  [[nodiscard]] OfLayer begin(int layer);
  /// The print has the layers below `layer` and no others.
  void end_at(int layer);

  /// Other values, or one more cancelled object (`kCancelObject`), from the next layer on that is
  /// not begun, and where there are changes to come
  /// already, not before the last of them. \return that layer; nothing, and nothing changes, if the
  /// print has no such layer. kInput as `changed`; kUnavailable while the print is being taken up,
  /// or after `kChangesMax` changes.
  [[nodiscard]] Result<std::optional<int>> change(const SettingTexts& values);
  /// All there were, in order; `from_layer` never falls.
  [[nodiscard]] std::vector<SettingsChange> changes() const;

  /// The print is taken up: `told` is what its journal tells of its changes, in order. What is
  /// known beyond that stays. Layers below `begun` are not changed, and none until `go_on`.
  /// \return kInput if `told` cannot have been done.
  [[nodiscard]] Result<void> take_up(const std::vector<SettingsChange>& told, int begun);
  /// All layers that were printed have been begun again.
  void go_on();

  /// The most bottom layers that any layer from `layer` on has.
  [[nodiscard]] int bottom_layers_from(int layer) const;

 private:
  struct State {
    Settings settings;
    std::vector<CancelledObject> cancelled;
  };
  struct Change {
    SettingsChange what;
    State after;  ///< All there is, from there on.
  };
  using Changes = std::vector<Change>;

  [[nodiscard]] Result<Changes> replayed(const std::vector<SettingsChange>& told) const;
  [[nodiscard]] State at(int layer) const;
  [[nodiscard]] static Result<State> after(State state, SettingTexts values);

  const Settings original_;

  mutable std::mutex mutex_;  ///< Protects what follows.
  Changes changes_;
  int begun_ = 0;  ///< Layers below were begun.
  std::optional<int> end_;
  bool taken_up_ = false;  ///< And does not go on yet.
};

}  // namespace slipstick
