#include "host/pause.h"

namespace slipstick {
namespace {

constexpr double kMargin = 5;  // mm, for machines that do not quite reach the ends of their beds

}  // namespace

ParkingPlace parking_place(const PrintSettings& settings) {
  const PrinterSettings& printer = settings.printer;
  const bool round = printer.bed_shape == BedShape::kRound;
  return {.x = round ? 0 : kMargin,
          .y = printer.bed_size.y / (round ? 2 : 1) - kMargin,
          .height_max = printer.bed_size.z,
          .retraction = settings.material.retraction,
          .retraction_speed = settings.material.retraction_speed,
          .travel_speed = settings.toolpath.travel_speed,
          .lift_speed = printer.z_speed_max};
}

bool Pause::heed(PrintControl::Wish wish, Manner manner) {
  const bool hold = wish == PrintControl::Wish::kPause;
  // One way at a time: who has not arrived does not turn back.
  if (hold == held_ || !lines_.empty()) return false;
  held_ = hold;
  if (hold) parked_ = place_ && manner == Manner::kPark;
  if (!parked_) return true;
  const auto lines =
      hold ? parking_lines(tracker_.state(), *place_) : returning_lines(tracker_.state(), *place_);
  lines_.assign(lines.begin(), lines.end());
  return true;
}

std::optional<Line> Pause::next() {
  if (lines_.empty()) return {};
  Line line = std::move(lines_.front());
  lines_.pop_front();
  return line;
}

}  // namespace slipstick
