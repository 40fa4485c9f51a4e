#pragma once

#include <cstdint>
#include <string>

#include "core/base/vec.h"
#include "core/job/settings.h"

namespace slipstick {

/// Writes moves as text, leaves out what does not change, and keeps time and filament.
class MoveWriter {
 public:
  explicit MoveWriter(const PrintSettings& settings) : settings_(settings) {}

  void line(std::string_view text);
  /// What came before has left the filament drawn back by `mm`. \pre Nothing was written yet.
  void retracted_by(double mm);
  /// The nozzle's height; no move if it is there.
  void height(double z);
  /// A travel, retracted if it is long. \pre `height` was set.
  void travel(Vec2 to);
  /// A move that lays `filament` mm at `speed` mm/s. What is too short to be written is added to
  /// the next.
  void extrude(Vec2 to, double filament, double speed);
  void retract();

  [[nodiscard]] std::string take_text() { return std::move(text_); }
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] double filament_mm() const { return filament_; }

 private:
  // Position in µm: what the printer is told.
  struct Micrometres {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const Micrometres&, const Micrometres&) = default;
  };

  void unretract();
  void move(std::string_view command, Micrometres to, double speed);
  void append_xy(Micrometres to);
  void append_e(double filament);
  void append_feed(double speed);
  [[nodiscard]] static Micrometres rounded(Vec2 p);
  [[nodiscard]] double way(Micrometres to) const;

  const PrintSettings& settings_;
  std::string text_;
  bool has_position_ = false;
  Micrometres at_;
  double z_ = -1;
  long feed_ = -1;            // mm/min
  bool retracted_ = true;     // as the layer before leaves it
  double owed_filament_ = 0;  // laid on paper, not yet written
  double filament_ = 0;
  double seconds_ = 0;
};

}  // namespace slipstick
