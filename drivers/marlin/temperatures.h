#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace slipstick {

/// One heater as the printer sees it, in °C. A broken sensor gives NaN or about -15.
struct HeaterReading {
  double celsius = 0;
  std::optional<double> target;

  friend bool operator==(const HeaterReading&, const HeaterReading&) = default;
};

/// A temperature report: `T:21.87 /0.00 B:22.10 /60.00 @:0 B@:0`.
struct Temperatures {
  static constexpr std::size_t kMaxTools = 16;

  std::optional<HeaterReading> hotend;  ///< The one in use.
  std::optional<HeaterReading> bed;
  std::optional<HeaterReading> chamber;
  std::vector<HeaterReading> tools;  ///< `T0:`, `T1:`, … when the printer has several.
  bool waiting = false;              ///< A blocking command is heating up: the report has a `W:`.

  friend bool operator==(const Temperatures&, const Temperatures&) = default;
};

/// Reads a report; items it cannot read are left out. Nothing unless it begins with a heater of its
/// own, because `B:` also stands in positions.
[[nodiscard]] std::optional<Temperatures> parse_temperatures(std::string_view text);

}  // namespace slipstick
