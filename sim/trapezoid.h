#pragma once

namespace slipstick {

/// Speed along one move: up from `entry`, along at `cruise`, down to `exit`, at one acceleration.
///
/// Where the move is too short for that, it turns around at the peak where both ramps meet.
class Trapezoid {
 public:
  struct Shape {
    double length = 0;  ///< mm.
    double entry = 0;   ///< mm/s, this and the next two.
    double cruise = 0;
    double exit = 0;
    double acceleration = 0;  ///< mm/s².
  };

  Trapezoid() = default;
  /// \pre Length, cruise and acceleration > 0; entry and exit in [0, cruise] and within reach of
  /// each other on `length`.
  explicit Trapezoid(const Shape& shape);

  [[nodiscard]] double seconds() const { return up_seconds_ + flat_seconds_ + down_seconds_; }
  [[nodiscard]] double peak() const { return peak_; }
  /// mm covered `t` seconds after the start; clamped to the move.
  [[nodiscard]] double distance_at(double t) const;

 private:
  Shape shape_;
  double peak_ = 0;
  double up_seconds_ = 0;
  double flat_seconds_ = 0;
  double down_seconds_ = 0;
};

}  // namespace slipstick
