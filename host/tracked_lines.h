#pragma once

#include <cstdint>
#include <utility>

#include "drivers/marlin/board_settings.h"
#include "drivers/marlin/print_state.h"
#include "host/line_source.h"

namespace slipstick {

/// The lines of another source, counted and followed.
class TrackedLines final : public LineSource {
 public:
  /// \param line how many lines of the job come before those of `source`; \param state what they
  /// made of the printer.
  TrackedLines(LineSource& source, std::uint64_t line, PrintStateTracker state)
      : source_(source), line_(line), state_(std::move(state)) {}
  explicit TrackedLines(LineSource& source) : TrackedLines(source, 0, {}) {}

  [[nodiscard]] Result<std::optional<Line>> next() override;
  [[nodiscard]] bool ready() const override { return source_.ready(); }
  [[nodiscard]] bool take_pause() override { return source_.take_pause(); }

  /// Lets lines go by until `line` of the job are done.
  /// \return kInput if the job has fewer.
  [[nodiscard]] Result<void> skip_to(std::uint64_t line);

  /// Lines of the job given out.
  [[nodiscard]] std::uint64_t line() const { return line_; }
  /// After the last line given out.
  [[nodiscard]] const PrintStateTracker& state() const { return state_; }
  [[nodiscard]] const BoardSettings& settings() const { return settings_; }

 private:
  LineSource& source_;
  std::uint64_t line_;
  PrintStateTracker state_;
  BoardSettings settings_;
};

}  // namespace slipstick
