/// \file
/// Instructions over points, some lanes at a time. Included where core/expr/lanes-inl.h is.

// Included once for each set of instructions.
// NOLINTBEGIN(misc-definitions-in-headers)

template <typename F>
HWY_INLINE void each(const PointRun& run, const Instruction& step, F f) {
  const double* a = run.registers + step.a * run.stride;
  double* out = run.registers + step.out * run.stride;
  for (std::size_t i = 0; i < run.points; i += hn::Lanes(Tag())) store(f(load(a + i)), out + i);
}

template <typename F>
HWY_INLINE void each_pair(const PointRun& run, const Instruction& step, F f) {
  const double* a = run.registers + step.a * run.stride;
  const double* b = run.registers + step.b * run.stride;
  double* out = run.registers + step.out * run.stride;
  for (std::size_t i = 0; i < run.points; i += hn::Lanes(Tag())) {
    store(f(load(a + i), load(b + i)), out + i);
  }
}

void fill(const PointRun& run, const Instruction& step) {
  double* out = run.registers + step.out * run.stride;
  std::fill_n(out, run.points, constant_of(step));
}

// The rare operations, by their definition.
void one_by_one(const PointRun& run, const Instruction& step) {
  const double* a = run.registers + step.a * run.stride;
  const double* b = is_binary(op_of(step.code)) ? run.registers + step.b * run.stride : a;
  double* out = run.registers + step.out * run.stride;
  for (std::size_t i = 0; i < run.points; ++i) out[i] = apply(op_of(step.code), a[i], b[i]);
}

void run_unary(const PointRun& run, const Instruction& step) {
  switch (op_of(step.code)) {
    case Op::kNegate:
      return each(run, step, [](Lanes p) HWY_ATTR { return -p; });
    case Op::kAbs:
      return each(run, step, [](Lanes p) HWY_ATTR { return absolute_of(p); });
    case Op::kSquare:
      return each(run, step, [](Lanes p) HWY_ATTR { return p * p; });
    case Op::kSqrt:
      return each(run, step, [](Lanes p) HWY_ATTR { return root_of(p); });
    case Op::kSin:
      return each(run, step, [](Lanes p) HWY_ATTR { return sine_of(p); });
    case Op::kCos:
      return each(run, step, [](Lanes p) HWY_ATTR { return cosine_of(p); });
    default:
      return one_by_one(run, step);
  }
}

void run_binary(const PointRun& run, const Instruction& step) {
  switch (op_of(step.code)) {
    case Op::kAdd:
      return each_pair(run, step, [](Lanes p, Lanes q) HWY_ATTR { return p + q; });
    case Op::kSubtract:
      return each_pair(run, step, [](Lanes p, Lanes q) HWY_ATTR { return p - q; });
    case Op::kMultiply:
      return each_pair(run, step, [](Lanes p, Lanes q) HWY_ATTR { return p * q; });
    case Op::kDivide:
      return each_pair(run, step, [](Lanes p, Lanes q) HWY_ATTR { return p / q; });
    case Op::kMin:
      return each_pair(run, step, [](Lanes p, Lanes q) HWY_ATTR { return lesser_of(p, q); });
    case Op::kMax:
      return each_pair(run, step, [](Lanes p, Lanes q) HWY_ATTR { return greater_of(p, q); });
    default:
      return one_by_one(run, step);
  }
}

void run_with_constant(const PointRun& run, const Instruction& step) {
  const Lanes c(step.code == Code::kCopy ? 0.0 : run.constants[step.b]);
  switch (step.code) {
    case Code::kAddConstant:
    case Code::kAddLeast:
      return each(run, step, [c](Lanes p) HWY_ATTR { return p + c; });
    case Code::kConstantMinus:
      return each(run, step, [c](Lanes p) HWY_ATTR { return c - p; });
    case Code::kScale:
      return each(run, step, [c](Lanes p) HWY_ATTR { return p * c; });
    default:
      return each(run, step, [](Lanes p) HWY_ATTR { return p; });
  }
}

void run_step(const PointRun& run, const Instruction& step) {
  if (step.code >= Code::kCopy) {
    run_with_constant(run, step);
  } else if (is_binary(op_of(step.code))) {
    run_binary(run, step);
  } else if (is_unary(op_of(step.code))) {
    run_unary(run, step);
  } else {
    fill(run, step);
  }
}

void RunPoints(const PointRun& run) {
  for (const Instruction& step : run.instructions) run_step(run, step);
}

void RunSigns(const SignRun& run) {
  for (std::size_t word = 0; word < run.points / 64; ++word) {
    std::uint64_t low = 0, undefined = 0;
    for (std::size_t i = 0; i < 64; i += hn::Lanes(Tag())) {
      const Lanes value = load(run.values + 64 * word + i);
      low |= std::uint64_t{bits_of(value <= Lanes(0.0))} << i;
      undefined |= std::uint64_t{bits_of(value != value)} << i;
    }
    run.at_most_zero[word] = low;
    run.undefined[word] = undefined;
  }
}

// NOLINTEND(misc-definitions-in-headers)
