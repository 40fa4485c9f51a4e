#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace slipstick::targets {

/// \file
/// Figures beside the targets they are held to, as rows of a table.

struct Row {
  std::string what;
  std::string target;
  std::string measured;  ///< With its spread or its parts.
  bool holds = false;
};

/// "4.31 (+12 %)": the least of some rounds and how far the worst of them was.
struct Timing {
  double least = 0;
  double most = 0;

  [[nodiscard]] std::string text(std::string_view unit) const;
};

/// CPU seconds of this process for one call of `work`, over `rounds` calls. CPU time, so that what
/// else runs on the machine does not count.
[[nodiscard]] Timing cpu_seconds(int rounds, const std::function<void()>& work);
/// Seconds on the wall, likewise.
[[nodiscard]] Timing wall_seconds(int rounds, const std::function<void()>& work);

/// Prints `rows` as a Markdown table.
void print(const std::vector<Row>& rows);

}  // namespace slipstick::targets
