#pragma once

#include <cstdint>

#include "core/base/box.h"
#include "core/solid/field.h"

namespace slipstick {

/// What is proved of the curve f = 0 in one square of the lattice.
struct CurveVerdict {
  bool certified = false;
  std::int64_t boxes = 0;  ///< Looked at.
};

inline constexpr int kSquareSplits = 4;

/// Splits `square`, a box of one height, in four, up to `kSquareSplits` times, wherever f may have
/// a zero and its slopes do not settle the matter.
///
/// Certified if f only rises along x, or only falls, or the same along y, in all parts that the
/// curve may pass. Then no line along that axis meets the curve twice within the square: between
/// two rises through zero there would be a fall. That is what one box without a zero of fx or fy
/// gives, and all that isotopy asks of it.
///
/// Certified, too, if f only rises or only falls along a diagonal there, and each side of the
/// square is met once at most, one of them not at all. Then there is no loop in the square, and
/// one piece of the curve at most, from side to side: a corner of the solid, or a turn that is
/// sharper than the lattice.
[[nodiscard]] CurveVerdict judge_curve(Field& field, const Box3& square);

}  // namespace slipstick
