#include "sim/job_timer.h"

#include <fmt/format.h>

namespace slipstick {

std::string JobTimer::text(Moment now) const {
  const Moment time = running_ || passed_ > Moment(0) ? passed(now) : last_;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time).count();
  const auto minutes = seconds / 60;
  const auto hours = minutes / 60;
  const auto days = hours / 24;
  if (days > 0) {
    return fmt::format("{}d {}h {}m {}s", days, hours % 24, minutes % 60, seconds % 60);
  }
  if (hours > 0) return fmt::format("{}h {}m {}s", hours, minutes % 60, seconds % 60);
  if (minutes > 0) return fmt::format("{}m {}s", minutes, seconds % 60);
  return fmt::format("{}s", seconds);
}

}  // namespace slipstick
