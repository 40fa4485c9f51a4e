/// \file
/// To be included within a namespace, once for each set of machine instructions (no guard): what is
/// compiled for wider vectors must be defined there. Needs core/base/pi_reduction.h.
///
/// Sine and cosine after reduction to an octant either side of zero, for one double or for a vector
/// of them: `F` has + - * and unary -, `choose(mask, yes, no)`, and comparisons that give masks.
/// Every lane goes through the same operations, so that all widths give the same bits.

/// The whole number next to `x`, of two the even one. \pre |x| < 2^51.
template <typename F>
F nearest_whole(F x) {
  const F shift(0x1.8p52);
  return (x + shift) - shift;
}

/// x = n·π/2 + high + low, |high| at most a little over π/4, for what `plainly_reducible` allows.
template <typename F>
QuarterTurns<F> reduce_plainly(F x) {
  // π/2 in parts: products of the first two with n are exact.
  const F first(0x1.921fb54400000p+0), second(0x1.0b4611a600000p-34), third(0x1.3198a2e037073p-69);
  const F n = nearest_whole(x * F(0x1.45f306dc9c883p-1));
  const F a = x - n * first;  // exact: a multiple of ulp(x) or 2^-32, and less than 1
  const F b = n * second;
  const F t = a - b;
  const F back = a - t;
  const F lost = (a - (t + back)) + (back - b);
  const F low = lost - n * third;
  const F high = t + low;
  return {n, high, (t - high) + low};
}

/// Beyond, n would have more bits than the parts of π/2 leave free.
inline constexpr double kPlainReach = 0x1p20;
/// Nearer to a multiple of π/2, the third part of π/2 would not do.
inline constexpr double kPlainNearness = 0x1p-30;

// Of one double; masks of several have their own.
inline bool both(bool a, bool b) {
  return a && b;
}
inline bool either(bool a, bool b) {
  return a || b;
}

template <typename F>
auto plainly_reducible(F x, const QuarterTurns<F>& r) {
  return both(absolute_of(x) <= F(kPlainReach),
              either(r.n == F(0.0), absolute_of(r.high) >= F(kPlainNearness)));
}

// Taylor's series: up to π/4 the first term left out is below 2^-63 of the value.
template <typename F>
F sine_near_zero(F high, F low) {
  const F z = high * high;
  F sum(1.0 / 355687428096000);
  sum = sum * z - F(1.0 / 1307674368000);
  sum = sum * z + F(1.0 / 6227020800);
  sum = sum * z - F(1.0 / 39916800);
  sum = sum * z + F(1.0 / 362880);
  sum = sum * z - F(1.0 / 5040);
  sum = sum * z + F(1.0 / 120);
  sum = sum * z - F(1.0 / 6);
  return high + (high * (z * sum) + low * (F(1.0) - F(0.5) * z));
}

template <typename F>
F cosine_near_zero(F high, F low) {
  const F z = high * high;
  F sum(-1.0 / 6402373705728000);
  sum = sum * z + F(1.0 / 20922789888000);
  sum = sum * z - F(1.0 / 87178291200);
  sum = sum * z + F(1.0 / 479001600);
  sum = sum * z - F(1.0 / 3628800);
  sum = sum * z + F(1.0 / 40320);
  sum = sum * z - F(1.0 / 720);
  sum = sum * z + F(1.0 / 24);
  const F half = F(0.5) * z;
  const F top = F(1.0) - half;
  return top + (((F(1.0) - top) - half) + (z * z * sum - high * low));
}

template <typename F>
auto is_odd(F whole) {
  const F half = F(0.5) * whole;
  return nearest_whole(half) != half;
}

/// sin(x + ahead·π/2).
template <typename F>
F sine_of(const QuarterTurns<F>& r, double ahead) {
  const F n = r.n + F(ahead);
  const auto crosswise = is_odd(n);
  const F value = choose(crosswise, cosine_near_zero(r.high, r.low), sine_near_zero(r.high, r.low));
  const F half_turns = F(0.5) * (n - choose(crosswise, F(1.0), F(0.0)));
  return choose(is_odd(half_turns), -value, value);
}

/// Below, sine and tangent are their argument, sign of zero included.
inline constexpr double kTiny = 0x1p-27;
