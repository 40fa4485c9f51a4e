/// \file
/// A chain along rows, undone from its value back to x, step by step for all rows of a tile.
/// Included where core/expr/lanes-inl.h is.

// Included once for each set of instructions.
// NOLINTBEGIN(misc-definitions-in-headers)

// What each operation may have rounded, on whatever side: far more than half a unit in the last
// place, and nothing on a lattice. The least is for what underflows when it is squared.
constexpr double kRoundingShare = 0x1p-46;
constexpr double kRoundingLeast = 1e-150;

// In one row, where a value is below zero: certainly below `at` by more than `doubt`, certainly not
// above `at` by more than `doubt`; the other way round once the chain has turned. NaN says nothing.
struct Threshold {
  Lanes at;
  Lanes doubt;
};

// Of all rows.
struct Thresholds {
  alignas(64) double at[kSpanTile];
  alignas(64) double doubt[kSpanTile];
  bool turned;
};

template <typename F>
HWY_INLINE void each_row(Thresholds& all, F f) {
  for (std::size_t row = 0; row < kSpanTile; row += hn::Lanes(Tag())) {
    const Threshold t = f(Threshold{load(all.at + row), load(all.doubt + row)}, row);
    store(t.at, all.at + row);
    store(t.doubt, all.doubt + row);
  }
}

// A sum may have rounded in either direction whatever was larger, and undoing it, too.
HWY_INLINE Threshold less(Threshold t, Lanes c) {
  const Lanes at = t.at - c;
  return {at, t.doubt + (absolute_of(at) + absolute_of(c)) * Lanes(kRoundingShare)};
}

HWY_INLINE Threshold scaled(Threshold t, Lanes by) {
  const Lanes at = t.at * by;
  return {at, t.doubt * absolute_of(by) + absolute_of(at) * Lanes(kRoundingShare) +
                  Lanes(kRoundingLeast)};
}

// A threshold below zero stays below zero: no root is below it.
HWY_INLINE Threshold squared(Threshold t) {
  const Lanes size = absolute_of(t.at), at = t.at * size;
  return {at, (size + size + t.doubt) * t.doubt + size * size * Lanes(kRoundingShare) +
                  Lanes(kRoundingLeast)};
}

// With |t| > 2d, √t moves by at most d/√|t|; nearer to zero by at most √|t| + √d < 4d/√|t|.
HWY_INLINE Threshold rooted(Threshold t) {
  const Lanes size = root_of(absolute_of(t.at));
  return {Lanes(hn::CopySign(size.v, t.at.v)),
          Lanes(4.0) * t.doubt / size + size * Lanes(kRoundingShare) + Lanes(kRoundingLeast)};
}

void mirror(Thresholds& all) {
  each_row(all, [](Threshold t, std::size_t) HWY_ATTR { return Threshold{-t.at, t.doubt}; });
  all.turned = !all.turned;
}

void undo_scale(Thresholds& all, double c) {
  if (c < 0) all.turned = !all.turned;
  each_row(all, [c](Threshold t, std::size_t) HWY_ATTR { return scaled(t, Lanes(1 / c)); });
}

void undo_sum(Thresholds& all, double c) {
  each_row(all, [c](Threshold t, std::size_t) HWY_ATTR { return less(t, Lanes(c)); });
}

// v = c - u.
HWY_INLINE Threshold from(Lanes c, Threshold t) {
  return less({-t.at, t.doubt}, -c);
}

void undo_difference(Thresholds& all, double c) {
  all.turned = !all.turned;
  each_row(all, [c](Threshold t, std::size_t) HWY_ATTR { return from(Lanes(c), t); });
}

void undo_with_row(Thresholds& all, const ChainStep& step) {
  const double* const rows = step.rows;
  if (op_of(step.code) == Op::kAdd) {
    return each_row(
        all, [rows](Threshold t, std::size_t row) HWY_ATTR { return less(t, load(rows + row)); });
  }
  if (!step.chain_is_second) {
    return each_row(
        all, [rows](Threshold t, std::size_t row) HWY_ATTR { return less(t, -load(rows + row)); });
  }
  all.turned = !all.turned;
  each_row(all,
           [rows](Threshold t, std::size_t row) HWY_ATTR { return from(load(rows + row), t); });
}

// One step with one way back.
void undo(Thresholds& all, const ChainStep& step) {
  switch (step.code) {
    case Code::kScale:
      return undo_scale(all, step.constant);
    case Code::kConstantMinus:
      return undo_difference(all, step.constant);
    case Code::kAddConstant:
    case Code::kAddLeast:
      return undo_sum(all, step.constant);
    default:
      break;
  }
  switch (op_of(step.code)) {
    case Op::kNegate:
      return mirror(all);
    case Op::kSqrt:
      return each_row(all, [](Threshold t, std::size_t) HWY_ATTR { return squared(t); });
    default:
      return undo_with_row(all, step);
  }
}

using WordTag = hn::RebindToUnsigned<Tag>;

// All but the first `count` bits. \pre A whole number from 0 to 64.
HWY_INLINE hn::Vec<WordTag> behind_bits(Lanes count) {
  const WordTag words;
  // 2^52 + n has n for its lowest bits; a shift by 64 is done as two by 32.
  const auto n = hn::And(hn::BitCast(words, (count + Lanes(0x1p52)).v), hn::Set(words, 127));
  const auto half = hn::ShiftRight<1>(n);
  return hn::Shl(hn::Shl(hn::Set(words, ~std::uint64_t{0}), half), hn::Sub(n, half));
}

// The columns before the thresholds of x itself. NaN is before none and up to all.
void write_spans(const ChainRun& run, const Thresholds& all, RowWords& out) {
  const WordTag words;
  const Lanes per_width(1 / run.width), first(static_cast<double>(run.first_column));
  const Lanes none(0.0), every(64.0);
  const auto turn = hn::Set(words, all.turned ? 0 : ~std::uint64_t{0});
  std::uint64_t* const before = all.turned ? out.maybe.data() : out.surely.data();
  std::uint64_t* const upto = all.turned ? out.surely.data() : out.maybe.data();
  for (std::size_t row = 0; row < kSpanTile; row += hn::Lanes(Tag())) {
    const Threshold t = less(scaled({load(all.at + row), load(all.doubt + row)}, per_width), first);
    // Columns from 0 below the one, and not above the other.
    const Lanes low = -floor_of(t.doubt - t.at), high = floor_of(t.at + t.doubt) + Lanes(1.0);
    const auto least = behind_bits(choose(low > none, choose(low < every, low, every), none));
    const auto most = behind_bits(choose(high < every, choose(high > none, high, none), every));
    hn::StoreU(hn::Xor(least, turn), words, before + row);
    hn::StoreU(hn::Xor(most, turn), words, upto + row);
  }
}

void undo_all(const ChainRun& run, std::size_t at, Thresholds& all, RowWords& out);

// |u| is at most t where u is at most t and at least -t, and at least t where one of both is.
void undo_fold(const ChainRun& run, std::size_t at, Thresholds& all, RowWords& out) {
  Thresholds other = all;
  mirror(other);
  RowWords of_other;
  const bool either = all.turned;
  undo_all(run, at, all, out);
  undo_all(run, at, other, of_other);
  for (std::size_t row = 0; row < kSpanTile; ++row) {
    out.surely[row] =
        either ? out.surely[row] | of_other.surely[row] : out.surely[row] & of_other.surely[row];
    out.maybe[row] =
        either ? out.maybe[row] | of_other.maybe[row] : out.maybe[row] & of_other.maybe[row];
  }
}

void undo_all(const ChainRun& run, std::size_t at, Thresholds& all, RowWords& out) {
  for (; at < run.steps.size(); ++at) {
    const Code code = run.steps[at].code;
    if (code == code_of(Op::kAbs)) return undo_fold(run, at + 1, all, out);
    if (code == code_of(Op::kSquare)) {
      each_row(all, [](Threshold t, std::size_t) HWY_ATTR { return rooted(t); });
      return undo_fold(run, at + 1, all, out);
    }
    undo(all, run.steps[at]);
  }
  write_spans(run, all, out);
}

void RunChain(const ChainRun& run) {
  Thresholds all;
  std::fill_n(all.at, kSpanTile, 0.0);
  std::fill_n(all.doubt, kSpanTile, kRoundingLeast);
  all.turned = false;
  undo_all(run, 0, all, *run.out);
}

// NOLINTEND(misc-definitions-in-headers)
