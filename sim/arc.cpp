#include "sim/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipstick {

namespace {

constexpr double kCircle = 2 * std::numbers::pi;

Vec2 flat(const Axes& a) {
  return {a.x, a.y};
}

/// From the start of an arc to its centre. \param turn 1 counter-clockwise, -1 clockwise.
std::optional<Vec2> to_centre(const GcodeCommand& command, Vec2 chord, double turn) {
  const double radius = command.value('R').value_or(0);
  if (!command.value('R')) {
    const Vec2 offset{command.value('I').value_or(0), command.value('J').value_or(0)};
    return offset == Vec2{} ? std::nullopt : std::optional(offset);
  }
  if (radius == 0 || chord == Vec2{}) return std::nullopt;
  // A negative radius asks for the longer way round: its centre is on the other side.
  const double side = radius < 0 ? -turn : turn;
  const double half = length(chord) / 2;
  const double height = std::sqrt(std::max(0.0, (radius - half) * (radius + half)));
  return 0.5 * chord + (side * height / length(chord)) * Vec2{-chord.y, chord.x};
}

double angle_of(Vec2 start, Vec2 end, double turn) {
  if (start == end) return turn * kCircle;
  const double angle = std::atan2(cross(start, end), dot(start, end));
  if (turn < 0) return angle < 0 ? angle : angle - kCircle;
  return angle < 0 ? angle + kCircle : angle;
}

int pieces_of(double millimetres, double angle) {
  const double fewest = std::max(1.0, std::ceil(Arc::kCirclePieces * std::abs(angle) / kCircle));
  double pieces = std::max(fewest, std::floor(millimetres / Arc::kPieceMax));
  if (millimetres < pieces * Arc::kPieceMin) {
    pieces = std::max(1.0, std::floor(millimetres / Arc::kPieceMin));
  }
  return static_cast<int>(std::min(pieces, static_cast<double>(Arc::kPiecesMax)));
}

}  // namespace

Arc::Arc(const Axes& from, const Axes& to, const Vec2& centre, double angle)
    : from_(from),
      to_(to),
      centre_(centre),
      angle_(angle),
      pieces_(pieces_of(std::abs(angle) * length(flat(from) - centre), angle)) {}

std::optional<Arc> Arc::of(const GcodeCommand& command, const Axes& from, const Axes& to) {
  const double turn = command.is('G', 2) ? -1 : 1;
  const auto offset = to_centre(command, flat(to) - flat(from), turn);
  if (!offset) return std::nullopt;
  const Vec2 centre = flat(from) + *offset;
  return Arc(from, to, centre, angle_of(flat(from) - centre, flat(to) - centre, turn));
}

Axes Arc::end_of(int i) const {
  if (i == pieces_) return to_;
  const double share = static_cast<double>(i) / pieces_;
  const double c = std::cos(share * angle_);
  const double s = std::sin(share * angle_);
  const Vec2 start = flat(from_) - centre_;
  const Vec2 at = centre_ + Vec2{c * start.x - s * start.y, s * start.x + c * start.y};
  return {at.x, at.y, from_.z + share * (to_.z - from_.z), from_.e + share * (to_.e - from_.e)};
}

}  // namespace slipstick
