#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/vec.h"
#include "core/expr/row_spans.h"
#include "core/image/bit_image.h"

namespace slipstick {

/// Paints {f <= 0} on a bit image through a tree of tiles: sixteen at a time are bounded by
/// intervals, what is left is asked with instructions shortened for the tile. A tile of a word's
/// width is drawn by spans of its rows if its instructions allow; else the smallest tiles are
/// evaluated node by node in vectors. Nothing is allocated for a tile.
///
/// The bits are those that the whole expression has at each node: min and max give one of their
/// operands, an operand of proven sign may be left out where only the sign counts, and nodes too
/// near to the end of a span are evaluated.
class ExprPainter {
 public:
  ExprPainter(const Program& program, BlockRegisters& registers, BitImage& image);

  void paint();

  /// The first node met where f is NaN.
  [[nodiscard]] const std::optional<Vec2>& undefined_at() const { return undefined_; }

 private:
  // Nodes [low, high) of both axes.
  struct Tile {
    int column_low, row_low, column_high, row_high;
  };
  // One level of the tree: what its tiles share.
  struct Level {
    int size;  // nodes a side
    BoxNotes notes;
    std::vector<Instruction> room;
    std::array<Tile, kBoxesMax> tiles{};
  };

  void split(const Listing& listing, const Tile& tile, std::size_t depth);
  void batch(const Listing& listing, std::size_t depth, std::size_t count);
  void spans(const Listing& listing, const Tile& tile);
  void doubtful(const Listing& listing, int first_column, int row, std::uint64_t open);
  void nodes(const Listing& listing, const Tile& tile);
  void write(const Tile& tile, const SignRun& signs);
  [[nodiscard]] BoxBatch boxes(const Level& level, std::size_t count) const;

  const Program& program_;
  BlockRegisters& registers_;
  BitImage& image_;
  Specializer specializer_;
  RowSpans row_spans_;
  std::vector<Level> levels_;
  std::vector<TileRegister> states_;
  std::optional<Vec2> undefined_;
};

}  // namespace slipstick
