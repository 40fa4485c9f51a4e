#pragma once

namespace slipstick {

/// x = n·π/2 + high + low, where low is what does not fit into high.
template <typename F>
struct QuarterTurns {
  F n;  ///< A whole number; only n modulo 4 counts.
  F high;
  F low;
};

/// Of any finite argument but 0, to about 2^-100 of the remainder (Payne and Hanek, 1983).
[[nodiscard]] QuarterTurns<double> reduce_exactly(double x);

}  // namespace slipstick
