#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "drivers/clock.h"
#include "sim/axes.h"
#include "sim/junction.h"
#include "sim/kinematics.h"
#include "sim/motion_limits.h"
#include "sim/trapezoid.h"

namespace slipstick {

/// A straight move that the machine has made.
struct ExecutedMove {
  Axes from;
  Axes to;
  double speed = 0;          ///< mm/s that was asked for and allowed.
  double start_seconds = 0;  ///< Since power on.
  double end_seconds = 0;

  /// mm of filament pushed; negative when retracting.
  [[nodiscard]] double filament() const { return to.e - from.e; }
};

/// What the planner has seen so far.
struct MotionStatistics {
  std::int64_t moves = 0;
  double filament_mm = 0;
  double first_extrusion_seconds = 0;  ///< Start of the first move that extrudes; 0 before.
  double last_move_seconds = 0;        ///< End of the last move made.
  std::int64_t starvations = 0;        ///< Times the machine stood because no move had come.
  double starved_seconds = 0;          ///< How long it stood in all.
};

/// Marlin's motion planner: a ring of 16 moves of which 15 can be used, trapezoids, look-ahead.
///
/// The speed at a corner comes from junction deviation or classic jerk (junction.h); a backward and
/// a forward pass then join the moves that have not begun, so that the machine can always stop at
/// the end of the last one. A move that follows a standstill waits 100 ms for company, or until
/// three are queued. As in Marlin, moves of less than 6 steps are kept back and made together with
/// the next one.
class Planner {
 public:
  static constexpr int kBlocks = 16;
  static constexpr int kUsable = kBlocks - 1;
  static constexpr int kStepsMin = 6;
  static constexpr int kCompany = 3;
  static constexpr double kFirstMoveDelay = 0.1;
  static constexpr double kSlowest = 0.05;  ///< mm/s: no move is slower.

  using Sink = std::function<void(const ExecutedMove&)>;

  /// `sink` gets every move when it ends, in order; it may be empty.
  explicit Planner(Sink sink, const Kinematics& kinematics = {})
      : sink_(std::move(sink)), kinematics_(kinematics) {}

  [[nodiscard]] bool full() const { return count_ == kUsable; }
  [[nodiscard]] bool idle() const { return count_ == 0; }
  [[nodiscard]] int queued() const { return count_; }

  /// Plans a move to `target` at `speed` mm/s along the path. \pre Not full; `speed` > 0.
  void add(const Axes& target, double speed, const MotionLimits& limits, Moment now);

  /// Forgets all moves and stands where it is, at once. \return Where that is.
  Axes stop(Moment now);

  /// Makes all moves that end by `now`. Time never goes back.
  void advance(Moment now);

  /// When a move ends or the first one starts.
  [[nodiscard]] std::optional<Moment> next_event() const;

  /// Where the last planned move ends.
  [[nodiscard]] const Axes& target() const { return target_; }
  /// Where the machine is at `now`.
  [[nodiscard]] Axes position(Moment now) const;
  /// Says that the last planned move ends at `position`; moves already queued keep their own
  /// numbers.
  void set_position(const Axes& position) { target_ = position; }
  /// Says that the firmware itself lets the machine stand, so that this is no starvation.
  void rest() { waiting_since_.reset(); }

  [[nodiscard]] const MotionStatistics& statistics() const { return statistics_; }

 private:
  struct Block {
    ExecutedMove move;
    Axes direction;  ///< Per mm of path.
    Leg leg;
    double entry2 = 0;  ///< Squared speeds, as all in look-ahead.
    double entry2_max = 0;
  };

  [[nodiscard]] Block& block(int i) { return blocks_[index(i)]; }
  [[nodiscard]] const Block& block(int i) const { return blocks_[index(i)]; }
  [[nodiscard]] std::size_t index(int i) const {
    return static_cast<std::size_t>((first_ + i) % kBlocks);
  }
  [[nodiscard]] Block planned(const Axes& target, double speed, const MotionLimits& limits) const;
  void plan_entry(Block& block, const MotionLimits& limits) const;
  /// Moves that have not begun.
  [[nodiscard]] int waiting() const { return count_ - (moving_ ? 1 : 0); }
  [[nodiscard]] double start_seconds() const;
  void look_ahead();
  void start(double at);
  void finish();

  Sink sink_;
  Kinematics kinematics_;
  std::array<Block, kBlocks> blocks_;
  int first_ = 0;
  int count_ = 0;
  bool moving_ = false;    ///< Whether block 0 has begun.
  Trapezoid profile_;      ///< Of block 0 while moving.
  double held_back_ = 0;   ///< When the first move after a standstill was queued.
  double company_at_ = 0;  ///< When the third one was.
  Axes target_;
  std::optional<double> waiting_since_;  ///< Since when the machine has stood without a reason.
  MotionStatistics statistics_;
};

}  // namespace slipstick
