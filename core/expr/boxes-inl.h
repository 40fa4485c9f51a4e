/// \file
/// Instructions over boxes: interval arithmetic, some boxes at a time. Included where
/// core/expr/lanes-inl.h is.

// Included once for each set of instructions.
// NOLINTBEGIN(misc-definitions-in-headers)

// Both bounds are NaN, or none is.
struct Bounds {
  Lanes low;
  Lanes high;
};

HWY_INLINE Bounds nowhere_if(Mask mask, Bounds x) {
  const Lanes nan(std::numeric_limits<double>::quiet_NaN());
  return {choose(mask, nan, x.low), choose(mask, nan, x.high)};
}

// What is infinite may cancel to NaN: `witness` is infinite or NaN if a bound is.
HWY_INLINE Bounds unless_infinite(Bounds x, Lanes witness) {
  const Lanes nothing = witness - witness;  // 0 or NaN
  return {x.low + nothing, x.high + nothing};
}

HWY_INLINE Bounds sum_of(Bounds a, Bounds b) {
  const Bounds sum{a.low + b.low, a.high + b.high};
  return unless_infinite(sum, sum.high - sum.low);
}

HWY_INLINE Bounds negative_of(Bounds a) {
  return {-a.high, -a.low};
}

HWY_INLINE Bounds around(Lanes p, Lanes q, Lanes r, Lanes s) {
  const Bounds x{lesser_of(lesser_of(p, q), lesser_of(r, s)),
                 greater_of(greater_of(p, q), greater_of(r, s))};
  return unless_infinite(x, (p + q) + (r + s));
}

HWY_INLINE Bounds product_of(Bounds a, Bounds b) {
  return around(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high);
}

HWY_INLINE Bounds quotient_of(Bounds a, Bounds b) {
  const Mask by_zero = (b.low <= Lanes(0.0)) & (b.high >= Lanes(0.0));
  const Bounds x = around(a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high);
  return nowhere_if(by_zero, unless_infinite(x, (a.high - a.low) + (b.high - b.low)));
}

HWY_INLINE Bounds square_of(Bounds a) {
  const Lanes p = a.low * a.low, q = a.high * a.high;
  const Mask zero = (a.low <= Lanes(0.0)) & (a.high >= Lanes(0.0));
  return {choose(zero, Lanes(0.0), lesser_of(p, q)), greater_of(p, q)};
}

HWY_INLINE Bounds magnitude_of(Bounds a) {
  const Lanes p = absolute_of(a.low), q = absolute_of(a.high);
  const Mask zero = (a.low <= Lanes(0.0)) & (a.high >= Lanes(0.0));
  return {choose(zero, Lanes(0.0), lesser_of(p, q)), greater_of(p, q)};
}

HWY_INLINE Bounds root_of(Bounds a) {
  return nowhere_if(a.low < Lanes(0.0), {root_of(a.low), root_of(a.high)});
}

// Whether some peak + 2πk lies in the interval, with room for rounding: saying yes is always safe.
HWY_INLINE Mask holds_peak(Bounds a, double peak) {
  const Lanes slack =
      Lanes(1e-9) * (Lanes(1.0) + greater_of(absolute_of(a.low), absolute_of(a.high)));
  const Lanes turn(1 / (2 * std::numbers::pi));
  const Lanes first = ((a.low - slack) - Lanes(peak)) * turn;
  return floor_of(((a.high + slack) - Lanes(peak)) * turn) >= first;
}

// Between the values at the ends, by the error of both further, unless a peak lies between.
HWY_INLINE Bounds wave(Bounds a, Bounds ends, double top) {
  const Lanes least = lesser_of(ends.low, ends.high), most = greater_of(ends.low, ends.high);
  const Lanes margin(4 * kElementaryUlps * 0x1p-52);  // of a value of at most 1
  const Mask far = (a.low < Lanes(-1e6)) | (a.high > Lanes(1e6));
  const Mask falls = far | holds_peak(a, top + std::numbers::pi) | (least - margin < Lanes(-1.0));
  const Mask rises = far | holds_peak(a, top) | (most + margin > Lanes(1.0));
  const Bounds x{choose(falls, Lanes(-1.0), least - margin),
                 choose(rises, Lanes(1.0), most + margin)};
  return unless_infinite(x, a.high - a.low);
}

struct Options {
  Mask value_is_a, value_is_b, sign_is_a, sign_is_b;
};

HWY_INLINE Options options_of_min(Bounds a, Bounds b) {
  return {a.high<b.low, b.high<a.low, b.low> Lanes(0.0), a.low> Lanes(0.0)};
}
HWY_INLINE Options options_of_max(Bounds a, Bounds b) {
  return {a.low > b.high, b.low > a.high, b.high < Lanes(0.0), a.high < Lanes(0.0)};
}

// Lane by lane through the scalar intervals.
Bounds rare(Op op, Bounds a, Bounds b) {
  constexpr std::size_t kMost = hn::MaxLanes(Tag());
  alignas(64) double parts[4][kMost];
  store(a.low, parts[0]);
  store(a.high, parts[1]);
  store(b.low, parts[2]);
  store(b.high, parts[3]);
  const auto interval = [](double low, double high) {
    return std::isnan(low) ? Interval::anything() : Interval::of(low, high);
  };
  for (std::size_t i = 0; i < hn::Lanes(Tag()); ++i) {
    const Interval x =
        apply(op, interval(parts[0][i], parts[1][i]), interval(parts[2][i], parts[3][i]));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    parts[0][i] = x.may_be_nan ? nan : x.low;
    parts[1][i] = x.may_be_nan ? nan : x.high;
  }
  return {load(parts[0]), load(parts[1])};
}

Bounds bounds_of_unary(Op op, Bounds a) {
  switch (op) {
    case Op::kNegate:
      return negative_of(a);
    case Op::kAbs:
      return magnitude_of(a);
    case Op::kSquare:
      return square_of(a);
    case Op::kSqrt:
      return root_of(a);
    case Op::kSin:
      return wave(a, {sine_of(a.low), sine_of(a.high)}, std::numbers::pi / 2);
    case Op::kCos:
      return wave(a, {cosine_of(a.low), cosine_of(a.high)}, 0);
    default:
      return rare(op, a, a);
  }
}

Bounds bounds_of_binary(Op op, Bounds a, Bounds b) {
  switch (op) {
    case Op::kAdd:
      return sum_of(a, b);
    case Op::kSubtract:
      return sum_of(a, negative_of(b));
    case Op::kMultiply:
      return product_of(a, b);
    case Op::kDivide:
      return quotient_of(a, b);
    case Op::kMin:
      return {lesser_of(a.low, b.low), lesser_of(a.high, b.high)};
    case Op::kMax:
      return {greater_of(a.low, b.low), greater_of(a.high, b.high)};
    default:
      return rare(op, a, b);
  }
}

Bounds bounds_with_constant(Code code, Bounds a, Lanes c) {
  switch (code) {
    case Code::kAddConstant:
    case Code::kAddLeast:
      return sum_of(a, {c, c});
    case Code::kConstantMinus:
      return sum_of({c, c}, negative_of(a));
    case Code::kScale: {
      const Lanes p = a.low * c, q = a.high * c;
      return unless_infinite({lesser_of(p, q), greater_of(p, q)}, p - q);
    }
    default:
      return a;
  }
}

HWY_INLINE Bounds bounds_at(const BoxRun& run, std::uint32_t index, std::size_t box) {
  const double* at = run.registers + std::size_t{2} * index * kBoxesMax + box;
  return {load(at), load(at + kBoxesMax)};
}

HWY_INLINE Bounds bounds_of(const BoxRun& run, const Instruction& step, std::size_t box) {
  if (step.code == code_of(Op::kConstant)) {
    const Lanes c(constant_of(step));
    return {c, c};
  }
  const Bounds a = bounds_at(run, step.a, box);
  if (step.code == Code::kCopy) return a;
  if (step.code > Code::kCopy) {
    return bounds_with_constant(step.code, a, Lanes(run.constants[step.b]));
  }
  if (is_unary(op_of(step.code))) return bounds_of_unary(op_of(step.code), a);
  return bounds_of_binary(op_of(step.code), a, bounds_at(run, step.b, box));
}

HWY_INLINE void note_options(const BoxRun& run, const Instruction& step, Choice& choice) {
  choice = {};
  const auto at = [](Mask mask, std::size_t box)
                      HWY_ATTR { return static_cast<std::uint16_t>(bits_of(mask) << box); };
  for (std::size_t box = 0; box < run.boxes; box += hn::Lanes(Tag())) {
    const Bounds a = bounds_at(run, step.a, box), b = bounds_at(run, step.b, box);
    const Options o = step.code == code_of(Op::kMin) ? options_of_min(a, b) : options_of_max(a, b);
    choice.value_is_a |= at(o.value_is_a, box);
    choice.value_is_b |= at(o.value_is_b, box);
    choice.sign_is_a |= at(o.sign_is_a, box);
    choice.sign_is_b |= at(o.sign_is_b, box);
  }
}

// Boxes where a rounding operation gives one value, whose bits are those of both bounds.
void note_settled(const BoxRun& run, const Instruction& step, Choice& choice) {
  const double* const at = run.registers + std::size_t{2} * step.out * kBoxesMax;
  choice = {};
  if (run.notes.settled.size() == kSettledMax) return;
  SettledValues values{};
  for (std::size_t box = 0; box < run.boxes; ++box) {
    values[box] = at[box];
    const bool one =
        std::bit_cast<std::uint64_t>(at[box]) == std::bit_cast<std::uint64_t>(at[kBoxesMax + box]);
    if (one && !std::isnan(at[box])) choice.settled |= static_cast<std::uint16_t>(1u << box);
  }
  if (choice.settled == 0) return;
  choice.values = static_cast<std::uint16_t>(run.notes.settled.size());
  run.notes.settled.push_back(values);
}

void RunBoxes(const BoxRun& run) {
  for (std::size_t i = 0; i < run.instructions.size(); ++i) {
    const Instruction& step = run.instructions[i];
    if (step.code == code_of(Op::kMin) || step.code == code_of(Op::kMax)) {
      note_options(run, step, run.notes.choices[i]);
    }
    for (std::size_t box = 0; box < run.boxes; box += hn::Lanes(Tag())) {
      const Bounds x = bounds_of(run, step, box);
      double* out = run.registers + std::size_t{2} * step.out * kBoxesMax + box;
      store(x.low, out);
      store(x.high, out + kBoxesMax);
    }
    if (rounds(step.code)) note_settled(run, step, run.notes.choices[i]);
  }
}

// NOLINTEND(misc-definitions-in-headers)
