#include "sim/bed_leveling.h"

#include <fmt/format.h>

#include <algorithm>

namespace slipstick {

void BedLeveling::probe() {
  constexpr double kBump = 0.12;
  constexpr double kTilt = 0.05;
  for (std::size_t row = 0; row < kSide; ++row) {
    for (std::size_t column = 0; column < kSide; ++column) {
      const double middle = row == 1 && column == 1 ? kBump : 0;
      heights_[row * kSide + column] = middle + kTilt * (static_cast<double>(column) - 1);
    }
  }
  measured_ = on_ = true;
}

std::string BedLeveling::grid_text() const {
  std::string text = "Bilinear Leveling Grid:\n ";
  for (std::size_t column = 0; column < kSide; ++column) text += fmt::format("{:>7}", column);
  for (std::size_t row = 0; row < kSide; ++row) {
    text += fmt::format("\n {}", row);
    for (std::size_t column = 0; column < kSide; ++column) {
      const double height = heights_[row * kSide + column];
      text += measured_ ? fmt::format(" {:+.3f}", height) : std::string("  =====");
    }
  }
  return text + "\n\n";
}

std::string BedLeveling::run(const GcodeCommand& command) {
  std::string text;
  if (const auto z = command.value('Z')) fade_height_ = std::max(0.0, *z);
  if (const auto s = command.value('S')) {
    on_ = *s != 0 && measured_;
    if (*s != 0 && !measured_) text += "Error:Failed to enable Bed Leveling\n";
  }
  if (command.has('V')) text += grid_text();
  return text + fmt::format("echo:Bed Leveling {}\necho:Fade Height {}\n", on_ ? "ON" : "OFF",
                            fade_height_ > 0 ? fmt::format("{:.2f}", fade_height_) : "OFF");
}

}  // namespace slipstick
