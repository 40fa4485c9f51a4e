#pragma once

#include <optional>

#include "core/gcode/parse.h"
#include "sim/axes.h"

namespace slipstick {

/// G2 and G3: an arc in the plane of X and Y, with Z and E in proportion, as the chain of straight
/// pieces that Marlin makes of it.
class Arc {
 public:
  static constexpr double kPieceMax = 1.0;  ///< mm: MAX_ARC_SEGMENT_MM.
  static constexpr double kPieceMin = 0.1;  ///< mm: MIN_ARC_SEGMENT_MM.
  static constexpr int kCirclePieces = 72;  ///< At least so many in a whole circle, and in part.
  static constexpr int kPiecesMax = 65'535;

  /// The arc of `command` from `from` to `to`, about the centre that I and J or R give. A radius
  /// too short to reach makes a half circle; an arc that ends where it begins is a whole circle.
  ///
  /// \return Nothing where no centre is given, or a radius for a whole circle.
  [[nodiscard]] static std::optional<Arc> of(const GcodeCommand& command, const Axes& from,
                                             const Axes& to);

  [[nodiscard]] int pieces() const { return pieces_; }
  /// Where piece `i` ends; the last exactly at the arc's end. \pre 0 < i <= pieces().
  [[nodiscard]] Axes end_of(int i) const;

 private:
  Arc(const Axes& from, const Axes& to, const Vec2& centre, double angle);

  Axes from_;
  Axes to_;
  Vec2 centre_;
  double angle_;  ///< Radians about the centre, counter-clockwise.
  int pieces_;
};

}  // namespace slipstick
