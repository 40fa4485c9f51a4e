#pragma once

#include <array>
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

/// Instructions over some boxes. Register r is kBoxesMax lower bounds and as many upper
/// bounds, both NaN where the value may be NaN. The bounds hold the values that `run_points` gives:
/// basic operations are rounded monotonously, so what the ends give, rounded the same way, needs no
/// margin; sine and cosine have theirs.
struct BoxRun {
  std::span<const Instruction> instructions;
  const double* constants;
  double* registers;
  Choice* choices;    ///< One an instruction; set for min and max.
  std::size_t boxes;  ///< At most `kBoxesMax`; some more may be looked at.
};
void run_boxes(const BoxRun& run);

/// Nodes a side of a tile that is drawn row by row.
inline constexpr std::size_t kSpanTile = 64;

/// One operation between x and a value. Its other operand, if it has one, is the constant of the
/// code or a value for each row.
struct ChainStep {
  Code code;
  bool chain_is_second;  ///< row - chain, not chain - row
  double constant;
  std::uint32_t row;   ///< Which of the values for each row...
  const double* rows;  ///< ...and where they are, `kSpanTile` of them.
};

/// For each row, the nodes where something certainly holds, and those where it may: what is in one
/// and not in the other is in doubt.
struct RowWords {
  std::array<std::uint64_t, kSpanTile> surely;
  std::array<std::uint64_t, kSpanTile> maybe;
};

/// Where a chain is below zero, with what is zero in doubt, by undoing its steps from
/// the value back to x. Node i of a row is at x = (first_column + i)·width, exactly.
struct ChainRun {
  std::span<const ChainStep> steps;  ///< The last operation first.
  std::int64_t first_column;
  double width;
  RowWords* out;
};
void run_chain(const ChainRun& run);

}  // namespace slipstick
