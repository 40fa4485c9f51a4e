#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "drivers/marlin/line.h"

namespace slipstick {

/// \file
/// What may be said to a printer between two lines of a print: what neither moves the nozzle, nor
/// waits, nor changes what the numbers of moves mean.

/// `text` as a line, if it is a command that has a place in a job. Fails (kInput) with the reason.
[[nodiscard]] Result<Line> command_line(std::string_view text);

/// The same, if it is such a command.
[[nodiscard]] Result<Line> interjection(std::string_view text);

/// What is to be different from now on; nothing stays as it is.
struct Adjustment {
  std::optional<double> feed;    ///< Of all speeds, %: 10 to 300.
  std::optional<double> flow;    ///< Of all extrusion, %: 50 to 200.
  std::optional<double> z;       ///< mm, 0.01 to 0.5 up or down, beside all coordinates (M290).
  std::optional<double> nozzle;  ///< °C asked for, 0 to 300.
  std::optional<double> bed;     ///< °C asked for, 0 to 150.
  std::optional<double> fan;     ///< 0 to 1.
};

/// The member of that name, or null.
[[nodiscard]] std::optional<double>* member_of(Adjustment& adjustment, std::string_view name);

/// The lines that do it, at most one for each. Fails (kInput) for what is out of range, or if
/// nothing is to be different.
[[nodiscard]] Result<std::vector<Line>> lines_of(const Adjustment& adjustment);

}  // namespace slipstick
