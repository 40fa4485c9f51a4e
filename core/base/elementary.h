#pragma once

namespace slipstick {

/// \file
/// Elementary functions made of the four basic operations, square roots and whole
/// numbers alone: the same bits with every compiler, library and machine of IEEE doubles.
///
/// Each is within `kElementaryUlps` units in the last place of the true value, for every argument
/// however large or small; zeros keep their sign, infinities and NaN do as in C (annex F). No
/// state, no errno.
inline constexpr int kElementaryUlps = 4;

[[nodiscard]] double sine(double x);
[[nodiscard]] double cosine(double x);
[[nodiscard]] double tangent(double x);
[[nodiscard]] double arc_sine(double x);
[[nodiscard]] double arc_cosine(double x);
[[nodiscard]] double arc_tangent(double x);
/// The angle of (x, y), in -pi to pi.
[[nodiscard]] double arc_tangent(double y, double x);
[[nodiscard]] double exponential(double x);
[[nodiscard]] double natural_logarithm(double x);

}  // namespace slipstick
