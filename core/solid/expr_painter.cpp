#include "core/solid/expr_painter.h"

#include <algorithm>
#include <bit>

namespace slipstick {
namespace {

constexpr int kLeaf = static_cast<int>(kTileSide);
constexpr int kRowTile = static_cast<int>(kSpanTile);

constexpr int kFanout = 4;  // tiles a side within a larger one
constexpr int kTopFanout = 2;
static_assert(kRowTile == BitImage::kBitsPerWord && kRowTile == kLeaf * kFanout);

// More tiles than this at the top, each asked with all instructions, and one more level costs less.
constexpr int kTopTilesMax = 16;

int tiles_across(int nodes, int size) {
  return (nodes + size - 1) / size;
}

}  // namespace

ExprPainter::ExprPainter(const Program& program, BlockRegisters& registers, BitImage& image)
    : program_(program), registers_(registers), image_(image) {}

void ExprPainter::paint() {
  const auto few = [this](int size) {
    return tiles_across(image_.columns(), size) * tiles_across(image_.rows(), size) <= kTopTilesMax;
  };
  std::vector<int> sizes = {kLeaf, kRowTile};
  while (!few(sizes.back())) {
    sizes.push_back(sizes.back() * (few(sizes.back() * kTopFanout) ? kTopFanout : kFanout));
  }
  for (std::size_t i = sizes.size(); i-- > 0;) levels_.push_back({sizes[i], {}, {}, {}});
  split(program_.listing(), {1, 1, image_.columns() - 1, image_.rows() - 1}, 0);
}

void ExprPainter::split(const Listing& listing, const Tile& tile, std::size_t depth) {
  const int size = levels_[depth].size;
  std::size_t count = 0;
  // Tiles begin at whole multiples of their size, so that bits stay within words.
  for (int row = tile.row_low / size * size; row < tile.row_high; row += size) {
    for (int column = tile.column_low / size * size; column < tile.column_high; column += size) {
      levels_[depth].tiles[count++] = {
          std::max(column, tile.column_low), std::max(row, tile.row_low),
          std::min(column + size, tile.column_high), std::min(row + size, tile.row_high)};
      if (count == kBoxesMax) {
        batch(listing, depth, count);
        count = 0;
      }
    }
  }
  if (count != 0) batch(listing, depth, count);
}

BoxBatch ExprPainter::boxes(const Level& level, std::size_t count) const {
  const SliceGrid& grid = image_.grid();
  BoxBatch result;
  result.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    const Tile& tile = level.tiles[i];
    result.x_low[i] = grid.node_x(tile.column_low);
    result.x_high[i] = grid.node_x(tile.column_high - 1);
    result.y_low[i] = grid.node_y(tile.row_low);
    result.y_high[i] = grid.node_y(tile.row_high - 1);
  }
  return result;
}

void ExprPainter::batch(const Listing& listing, std::size_t depth, std::size_t count) {
  Level& level = levels_[depth];
  const std::size_t length = listing.instructions.size();
  if (level.room.size() < length) level.room.resize(length);
  const BoxVerdict verdict = bound(listing, program_, boxes(level, count), registers_, level.notes);
  for (std::size_t i = 0; i < count; ++i) {
    const Tile tile = level.tiles[i];
    if ((verdict.above_zero >> i & 1) != 0) continue;
    if ((verdict.at_most_zero >> i & 1) != 0) {
      image_.fill(tile.column_low, tile.row_low, tile.column_high - tile.column_low,
                  tile.row_high - tile.row_low);
      continue;
    }
    const Listing inner =
        specializer_.specialize(listing, level.notes, i, Demand::kSign, level.room);
    const bool defined = (verdict.undefined >> i & 1) == 0;
    if (level.size == kRowTile && defined && row_spans_.lower(inner, program_.constants())) {
      spans(inner, tile);
    } else if (level.size == kLeaf) {
      nodes(inner, tile);
    } else {
      split(inner, tile, depth + 1);
    }
  }
}

// \pre The listing has just been lowered.
void ExprPainter::spans(const Listing& listing, const Tile& tile) {
  const SliceGrid& grid = image_.grid();
  const int first_column = tile.column_low / kRowTile * kRowTile;
  SpanTile where{grid.first_column() + first_column, grid.width(), {}};
  for (int i = 0; i < kRowTile; ++i) {
    where.ys[static_cast<std::size_t>(i)] = grid.node_y(tile.row_low + i);
  }
  const RowWords& words = row_spans_.draw(where, registers_);
  const int shift = tile.column_low - first_column;
  const std::uint64_t in_tile =
      ~std::uint64_t{0} >> (kRowTile - (tile.column_high - tile.column_low));
  for (int row = tile.row_low; row < tile.row_high; ++row) {
    const auto i = static_cast<std::size_t>(row - tile.row_low);
    image_.set_bits(tile.column_low, row, words.surely[i] >> shift & in_tile);
    const std::uint64_t open = (words.maybe[i] & ~words.surely[i]) >> shift & in_tile;
    if (open != 0) doubtful(listing, tile.column_low, row, open);
  }
}

// The nodes of a row that the spans leave open, a bit a column.
void ExprPainter::doubtful(const Listing& listing, int first_column, int row, std::uint64_t open) {
  const SliceGrid& grid = image_.grid();
  std::array<double, kSpanTile> xs, ys;
  std::array<int, kSpanTile> columns;
  std::size_t count = 0;
  for (; open != 0; open &= open - 1, ++count) {
    columns[count] = first_column + std::countr_zero(open);
    xs[count] = grid.node_x(columns[count]);
    ys[count] = grid.node_y(row);
  }
  const auto values = evaluate(listing, program_, std::span(xs).first(count),
                               std::span(ys).first(count), registers_);
  for (std::size_t i = 0; i < count; ++i) {
    if (values[i] <= 0) image_.set(columns[i], row, true);
  }
}

void ExprPainter::nodes(const Listing& listing, const Tile& tile) {
  const SliceGrid& grid = image_.grid();
  double* const values = registers_.prepare(listing.registers, kBlockPoints);
  const int first_column = tile.column_low / kLeaf * kLeaf;
  const int first_row = tile.row_low / kLeaf * kLeaf;
  for (int i = 0; i < kLeaf; ++i) {
    values[i] = grid.node_x(first_column + i);
    values[kBlockPoints + static_cast<std::size_t>(i)] = grid.node_y(first_row + i);
  }
  states_.assign(listing.registers, {});
  states_[kRegisterX] = {true, false, false};
  states_[kRegisterY] = {false, true, false};
  run_tile(
      {listing.instructions, program_.constants().data(), values, states_.data(), listing.result});
  std::array<std::uint64_t, kBlockPoints / 64> inside{}, undefined{};
  const SignRun signs{values + listing.result * kBlockPoints, kBlockPoints, inside.data(),
                      undefined.data()};
  run_signs(signs);
  write(tile, signs);
}

void ExprPainter::write(const Tile& tile, const SignRun& signs) {
  const int across = tile.column_high - tile.column_low;
  for (int row = tile.row_low; row < tile.row_high; ++row) {
    const int first = row % kLeaf * kLeaf + tile.column_low % kLeaf;
    const auto bits_in = [&](const std::uint64_t* words) {
      return words[first / 64] >> (first % 64) & ((std::uint64_t{1} << across) - 1);
    };
    image_.set_bits(tile.column_low, row, bits_in(signs.at_most_zero));
    const std::uint64_t undefined = bits_in(signs.undefined);
    if (undefined != 0 && !undefined_) {
      const int column = tile.column_low + std::countr_zero(undefined);
      undefined_ = {image_.grid().node_x(column), image_.grid().node_y(row)};
    }
  }
}

}  // namespace slipstick
