#pragma once

#include <memory>
#include <optional>

#include "core/base/result.h"
#include "drivers/marlin/line.h"

namespace slipstick {

/// Where the lines of a print come from.
class LineSource {
 public:
  LineSource() = default;
  LineSource(const LineSource&) = delete;
  LineSource& operator=(const LineSource&) = delete;
  virtual ~LineSource() = default;

  /// The next line; nothing after the last. May wait for it to be made.
  [[nodiscard]] virtual Result<std::optional<Line>> next() = 0;

  /// Whether `next` would not wait.
  [[nodiscard]] virtual bool ready() const = 0;

  /// Whether the print is to be paused before the next line. Yes at most once for each line.
  [[nodiscard]] virtual bool take_pause() { return false; }
};

}  // namespace slipstick
