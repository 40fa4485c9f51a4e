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

/// Instructions over points. Register r begins at registers + r·stride, aligned to 64 bytes; x and
/// y are set.
struct PointRun {
  std::span<const Instruction> instructions;
  const double* constants;
  double* registers;
  std::size_t points;  ///< A multiple of 8.
  std::size_t stride;  ///< At least as many.
};
void run_points(const PointRun& run);

/// Nodes a side of a tile that is evaluated node by node.
inline constexpr std::size_t kTileSide = 16;
/// Points that are evaluated together.
inline constexpr std::size_t kBlockPoints = kTileSide * kTileSide;

/// What a register over a tile depends on, and whether each node has its value; else only the first
/// row has, or the first `kTileSide` values are those of the rows in turn.
struct TileRegister {
  bool of_x = true;
  bool of_y = true;
  bool spread = true;
};

/// Instructions over the nodes of a tile, row by row. Of x the first row is set, of y the first
/// values, one a row. Gives the bits of `run_points`.
struct TileRun {
  std::span<const Instruction> instructions;
  const double* constants;
  double* registers;     ///< Register r begins at registers + r·kBlockPoints.
  TileRegister* states;  ///< One a register; x and y are set.
  std::uint32_t result;  ///< A register that each node is to have a value of.
};
void run_tile(const TileRun& run);

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
  std::size_t boxes;  ///< At most `kBoxesMax`; some more may be looked at.
  BoxNotes& notes;    ///< Prepared for the instructions; written.
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
