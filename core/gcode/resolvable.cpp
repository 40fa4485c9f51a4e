#include "core/gcode/resolvable.h"

#include <algorithm>
#include <cmath>

#include "core/toolpath/flow.h"

namespace slipstick {
namespace {

bool is_resolvable(Vec2 from, Vec2 to) {
  return std::abs(to.x - from.x) >= kMoveMin || std::abs(to.y - from.y) >= kMoveMin;
}

std::vector<Piece> all_pieces(const Bead& bead, double height) {
  std::vector<Piece> pieces;
  const std::size_t count = bead.closed ? bead.points.size() : bead.points.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 to = bead.points[i + 1 < bead.points.size() ? i + 1 : 0];
    const double width = bead.widths.size() == 1 ? bead.widths[0] : bead.widths[i];
    pieces.push_back({to, bead_area(width, height) * length(to - bead.points[i])});
  }
  return pieces;
}

// All of it in one move of the least length, about the middle of where it would have been.
Moves stretched(Vec2 from, const std::vector<Piece>& pieces) {
  Vec2 low = from, high = from;
  double volume = 0;
  for (const Piece& piece : pieces) {
    low = {std::min(low.x, piece.to.x), std::min(low.y, piece.to.y)};
    high = {std::max(high.x, piece.to.x), std::max(high.y, piece.to.y)};
    volume += piece.volume;
  }
  const Vec2 middle = 0.5 * (low + high), half{kMoveMin / 2, 0};
  return {middle - half, {{middle + half, volume}}};
}

}  // namespace

Moves resolvable_moves(const Bead& bead, double height) {
  const std::vector<Piece> pieces = all_pieces(bead, height);
  Moves moves{bead.points.front(), {}};
  const auto last = [&moves] { return moves.pieces.empty() ? moves.from : moves.pieces.back().to; };
  double volume = 0;
  for (const Piece& piece : pieces) {
    volume += piece.volume;
    if (!is_resolvable(last(), piece.to)) continue;
    moves.pieces.push_back({piece.to, volume});
    volume = 0;
  }
  if (moves.pieces.empty()) return stretched(moves.from, pieces);
  // What is left over at the end goes with the last move, which now ends where the bead does, if it
  // can.
  Piece& end = moves.pieces.back();
  end.volume += volume;
  const Vec2 before =
      moves.pieces.size() > 1 ? moves.pieces[moves.pieces.size() - 2].to : moves.from;
  if (is_resolvable(before, pieces.back().to)) end.to = pieces.back().to;
  return moves;
}

}  // namespace slipstick
