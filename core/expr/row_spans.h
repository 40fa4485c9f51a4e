#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/expr/block.h"

namespace slipstick {

/// Where on the lattice a tile of `kSpanTile` by `kSpanTile` nodes lies: node (column, row) of it
/// is at ((first_column + column)·width, ys[row]).
struct SpanTile {
  std::int64_t first_column;
  double width;
  std::array<double, kSpanTile> ys;
};

/// The sign of an expression over a tile as boolean operations on whole rows of nodes.
///
/// Along a row y is constant. What only ever adds a constant of the row to x, scales, negates,
/// takes the root, the square or the magnitude is a chain, and can be undone from its sign back to
/// x: half planes, discs, balls, cylinders, boxes, and shells of them. Every operation is rounded
/// monotonously, so the columns where a chain is below zero are one or a few spans, and their ends
/// are where undoing says, up to rounding, which is bounded on the way. Nodes within the bound are
/// said to be in doubt and are left to the arithmetic: the bits are those of the instructions.
///
/// Keeps its memory. For one thread.
class RowSpans {
 public:
  /// Takes the listing apart. \return Whether it is made of chains by min, max and change of sign;
  /// else it cannot be drawn. \pre The constants outlive the drawing.
  [[nodiscard]] bool lower(const Listing& listing, std::span<const double> constants);

  /// Where the listing lowered last is at most zero. \pre It is not NaN on nodes that count.
  /// \return Good until the next call.
  [[nodiscard]] const RowWords& draw(const SpanTile& tile, BlockRegisters& registers);

 private:
  enum class Kind : std::uint8_t { kUnknown, kRows, kChain, kSigns };
  // What a register holds: a value for each row, a link of a chain, or the signs that a join has,
  // or of what is its negative.
  struct Content {
    Kind kind = Kind::kUnknown;
    bool negative = false;
    std::uint32_t index = 0;
  };
  struct Link {
    ChainStep step;
    std::uint32_t before;  // another link; the first is x itself
    std::uint8_t folds;
    std::uint8_t length;
  };
  // The lesser or the greater of two.
  struct Join {
    bool greater;
    Content a, b;
  };

  [[nodiscard]] Content lowered(const Instruction& step);
  [[nodiscard]] Content rows(Instruction step);
  [[nodiscard]] Content link(const Instruction& step);
  [[nodiscard]] Content join(const Instruction& step);
  void draw(const Join& join, const SpanTile& tile, RowWords& out);
  [[nodiscard]] const RowWords& signs(Content content, const SpanTile& tile, RowWords& room);
  void sign_of_rows(std::uint32_t index, RowWords& out) const;
  void sign_of_chain(std::uint32_t link, const SpanTile& tile, RowWords& out);

  std::span<const double> constants_;
  std::vector<Content> contents_;       // of a register
  std::vector<Instruction> row_steps_;  // on values a row
  std::uint32_t row_registers_ = 0;
  const double* row_values_ = nullptr;
  std::vector<Link> links_;
  std::vector<Join> joins_;
  Content result_;
  std::vector<ChainStep> chain_;
  std::vector<RowWords> words_;  // of a join
  RowWords room_a_{}, room_b_{};
};

}  // namespace slipstick
