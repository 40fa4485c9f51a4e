/// \file
/// Instructions over the nodes of a square tile: what depends on x alone is done for one row of it,
/// what depends on y alone for one column. Included where core/expr/points-inl.h is.

// Included once for each set of instructions.
// NOLINTBEGIN(misc-definitions-in-headers)

static_assert(kTileSide % hn::MaxLanes(Tag()) == 0);

// To all rows what is in the first; to all of a row what is in the first values in turn.
void spread(double* values, TileRegister& state) {
  if (state.spread) return;
  state.spread = true;
  if (!state.of_y) {
    for (std::size_t row = 1; row < kTileSide; ++row) {
      std::copy_n(values, kTileSide, values + row * kTileSide);
    }
    return;
  }
  for (std::size_t row = kTileSide; row-- > 0;) {
    std::fill_n(values + row * kTileSide, kTileSide, values[row]);
  }
}

// Whether the first values of a register are those of the row or the column that is asked for.
HWY_INLINE bool is_line(const TileRegister& state, bool of_y) {
  return of_y ? !state.of_x && !(state.of_y && state.spread) : !state.of_y;
}

void RunTile(const TileRun& run) {
  const PointRun line{{}, run.constants, run.registers, kTileSide, kBlockPoints};
  const PointRun whole{{}, run.constants, run.registers, kBlockPoints, kBlockPoints};
  for (const Instruction& step : run.instructions) {
    TileRegister& out = run.states[step.out];
    if (step.code == code_of(Op::kConstant)) {
      run_step(whole, step);
      out = {false, false, true};
      continue;
    }
    const bool pair = step.code < Code::kCopy && is_binary(op_of(step.code));
    TileRegister& a = run.states[step.a];
    TileRegister& b = pair ? run.states[step.b] : a;
    const bool of_x = a.of_x || b.of_x, of_y = a.of_y || b.of_y;
    if (!(of_x && of_y) && is_line(a, of_y) && is_line(b, of_y)) {
      run_step(line, step);
      out = {of_x, of_y, false};
      continue;
    }
    spread(run.registers + step.a * kBlockPoints, a);
    if (pair) spread(run.registers + step.b * kBlockPoints, b);
    run_step(whole, step);
    out = {of_x, of_y, true};
  }
  spread(run.registers + run.result * kBlockPoints, run.states[run.result]);
}

// NOLINTEND(misc-definitions-in-headers)
