#include "core/expr/row_spans.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {
namespace {

// What a chain may have: each fold doubles the ends of its spans.
constexpr std::uint8_t kFoldsMax = 2;
constexpr std::uint8_t kLengthMax = 32;

// Beyond these, what scaling loses to underflow would have to be bounded, too.
constexpr double kScaleMin = 1e-90;
constexpr double kScaleMax = 1e90;

constexpr std::uint32_t kRowOfY = 0;

bool is_choice(Code code) {
  return code == code_of(Op::kMin) || code == code_of(Op::kMax);
}

bool is_fold(Code code) {
  return code == code_of(Op::kSquare) || code == code_of(Op::kAbs);
}

bool has_constant(Code code) {
  return code > Code::kCopy;
}

bool has_second_register(const Instruction& step) {
  return step.code < Code::kCopy && is_binary(op_of(step.code));
}

// Whether a chain may go on with it if its other operand, if any, is a value of the row.
bool can_be_undone(const Instruction& step, double constant) {
  if (step.code == Code::kScale) {
    return std::abs(constant) >= kScaleMin && std::abs(constant) <= kScaleMax;
  }
  if (has_constant(step.code)) return std::isfinite(constant);
  return is_fold(step.code) || step.code == code_of(Op::kNegate) ||
         step.code == code_of(Op::kSqrt) || step.code == code_of(Op::kAdd) ||
         step.code == code_of(Op::kSubtract);
}

}  // namespace

bool RowSpans::lower(const Listing& listing, std::span<const double> constants) {
  constants_ = constants;
  row_steps_.clear();
  row_registers_ = kRowOfY + 1;
  links_.assign(1, {});
  joins_.clear();
  contents_.assign(listing.registers, {});
  contents_[kRegisterX] = {Kind::kChain, false, 0};
  contents_[kRegisterY] = {Kind::kRows, false, kRowOfY};
  for (const Instruction& step : listing.instructions) {
    const Content content = lowered(step);
    if (content.kind == Kind::kUnknown) return false;
    contents_[step.out] = content;
  }
  result_ = contents_[listing.result];
  words_.resize(std::max(words_.size(), joins_.size()));
  return true;
}

RowSpans::Content RowSpans::lowered(const Instruction& step) {
  if (step.code == code_of(Op::kConstant)) return rows(step);
  const Content a = contents_[step.a];
  if (step.code == Code::kCopy) return a;
  const Kind b = has_second_register(step) ? contents_[step.b].kind : Kind::kRows;
  if (a.kind == Kind::kRows && b == Kind::kRows) return rows(step);
  if (is_choice(step.code)) return join(step);
  if (a.kind != Kind::kSigns && b != Kind::kSigns) return link(step);
  if (step.code == code_of(Op::kNegate)) return {Kind::kSigns, !a.negative, a.index};
  // It decides where its operand is zero, which is in doubt.
  if (step.code == Code::kAddLeast) return a;
  return {};
}

RowSpans::Content RowSpans::rows(Instruction step) {
  if (step.code != code_of(Op::kConstant)) step.a = contents_[step.a].index;
  if (has_second_register(step)) step.b = contents_[step.b].index;
  step.out = row_registers_++;
  row_steps_.push_back(step);
  return {Kind::kRows, false, step.out};
}

RowSpans::Content RowSpans::link(const Instruction& step) {
  ChainStep undone{step.code, false, 0, kRowOfY, nullptr};
  Content inner = contents_[step.a];
  if (has_constant(step.code)) undone.constant = constants_[step.b];
  if (!can_be_undone(step, undone.constant)) return {};
  if (has_second_register(step)) {
    const Content other = contents_[step.b];
    if (inner.kind == other.kind) return {};  // x in both
    undone.chain_is_second = inner.kind == Kind::kRows;
    undone.row = undone.chain_is_second ? inner.index : other.index;
    if (undone.chain_is_second) inner = other;
  }
  const Link& before = links_[inner.index];
  const int folds = before.folds + (is_fold(step.code) ? 1 : 0);
  if (folds > kFoldsMax || before.length == kLengthMax) return {};
  links_.push_back({undone, inner.index, static_cast<std::uint8_t>(folds),
                    static_cast<std::uint8_t>(before.length + 1)});
  return {Kind::kChain, false, static_cast<std::uint32_t>(links_.size() - 1)};
}

RowSpans::Content RowSpans::join(const Instruction& step) {
  joins_.push_back({step.code == code_of(Op::kMax), contents_[step.a], contents_[step.b]});
  return {Kind::kSigns, false, static_cast<std::uint32_t>(joins_.size() - 1)};
}

void RowSpans::sign_of_rows(std::uint32_t index, RowWords& out) const {
  const double* const values = row_values_ + std::size_t{index} * kSpanTile;
  for (std::size_t row = 0; row < kSpanTile; ++row) {
    out.surely[row] = values[row] < 0 ? ~std::uint64_t{0} : 0;
    out.maybe[row] = values[row] <= 0 ? ~std::uint64_t{0} : 0;
  }
}

void RowSpans::sign_of_chain(std::uint32_t link, const SpanTile& tile, RowWords& out) {
  chain_.clear();
  for (std::uint32_t at = link; at != 0; at = links_[at].before) {
    chain_.push_back(links_[at].step);
    chain_.back().rows = row_values_ + std::size_t{chain_.back().row} * kSpanTile;
  }
  run_chain({chain_, tile.first_column, tile.width, &out});
}

// Those of a join, or of something else written to `room`.
const RowWords& RowSpans::signs(Content content, const SpanTile& tile, RowWords& room) {
  if (content.kind == Kind::kSigns && !content.negative) return words_[content.index];
  switch (content.kind) {
    case Kind::kRows:
      sign_of_rows(content.index, room);
      break;
    case Kind::kChain:
      sign_of_chain(content.index, tile, room);
      break;
    default:
      const RowWords& words = words_[content.index];
      for (std::size_t row = 0; row < kSpanTile; ++row) {
        room.surely[row] = ~words.maybe[row];
        room.maybe[row] = ~words.surely[row];
      }
  }
  return room;
}

void RowSpans::draw(const Join& join, const SpanTile& tile, RowWords& out) {
  const RowWords& a = signs(join.a, tile, room_a_);
  const RowWords& b = signs(join.b, tile, room_b_);
  if (join.greater) {
    for (std::size_t i = 0; i < kSpanTile; ++i) out.surely[i] = a.surely[i] & b.surely[i];
    for (std::size_t i = 0; i < kSpanTile; ++i) out.maybe[i] = a.maybe[i] & b.maybe[i];
  } else {
    for (std::size_t i = 0; i < kSpanTile; ++i) out.surely[i] = a.surely[i] | b.surely[i];
    for (std::size_t i = 0; i < kSpanTile; ++i) out.maybe[i] = a.maybe[i] | b.maybe[i];
  }
}

const RowWords& RowSpans::draw(const SpanTile& tile, BlockRegisters& registers) {
  double* const values = registers.prepare(row_registers_, kSpanTile);
  row_values_ = values;
  std::copy(tile.ys.begin(), tile.ys.end(), values + std::size_t{kRowOfY} * kSpanTile);
  run_points({row_steps_, constants_.data(), values, kSpanTile, kSpanTile});
  for (std::size_t i = 0; i < joins_.size(); ++i) draw(joins_[i], tile, words_[i]);
  return signs(result_, tile, room_a_);
}

}  // namespace slipstick
