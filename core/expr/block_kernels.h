#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/expr/specialize.h"

namespace slipstick {

/// \file
/// The vector loops behind `core/expr/block.h`, compiled for several instruction sets, of which the
/// best the machine has is taken when it runs. No fused multiply-add anywhere: all give the same
/// bits.

/// Instructions over points. Register r begins at registers + r·points, aligned to 64 bytes; x and
/// y are set.
struct PointRun {
  std::span<const Instruction> instructions;
  const double* constants;
  double* registers;
  std::size_t points;  ///< A multiple of 8.
};
void run_points(const PointRun& run);

/// Sets bit i of `at_most_zero` where values[i] <= 0, and of `undefined` where it is NaN.
struct SignRun {
  const double* values;
  std::size_t points;  ///< A multiple of 64.
  std::uint64_t* at_most_zero;
  std::uint64_t* undefined;
};
void run_signs(const SignRun& run);

/// Instructions over `kBoxesMax` boxes. Register r is kBoxesMax lower bounds and as many upper
/// bounds, both NaN where the value may be NaN. The bounds hold the values that `run_points` gives:
/// basic operations are rounded monotonously, so what the ends give, rounded the same way, needs no
/// margin; sine and cosine have theirs.
struct BoxRun {
  std::span<const Instruction> instructions;
  const double* constants;
  double* registers;
  Choice* choices;  ///< One an instruction; set for min and max.
};
void run_boxes(const BoxRun& run);

}  // namespace slipstick
