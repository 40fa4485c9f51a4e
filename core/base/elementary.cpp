#include "core/base/elementary.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/base/pi_reduction.h"

namespace slipstick {
namespace {

// A double as a vector of one lane.
double choose(bool mask, double yes, double no) {
  return mask ? yes : no;
}
double absolute_of(double x) {
  return std::abs(x);
}

#include "core/expr/sine_kernel-inl.h"

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = 0x1.921fb54442d18p+1, kPiRest = 0x1.1a62633145c07p-53;

// \pre x is finite.
QuarterTurns<double> reduced(double x) {
  const QuarterTurns<double> r = reduce_plainly(x);
  return plainly_reducible(x, r) ? r : reduce_exactly(x);
}

struct Pair {
  double high;
  double low;
};

// arctan(i/8).
constexpr std::array<Pair, 9> kArcs{{{0, 0},
                                     {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                     {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                     {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                     {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                     {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                     {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                     {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                     {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

// Taylor's series, for |t| <= 1/16.
double arc_near_zero(double t) {
  const double z = t * t;
  double sum = -1.0 / 15;
  for (const double term : {1.0 / 13, -1.0 / 11, 1.0 / 9, -1.0 / 7, 1.0 / 5, -1.0 / 3}) {
    sum = sum * z + term;
  }
  return t + t * (z * sum);
}

// arctan a = arctan c + arctan((a - c) / (1 + ac)), c the next eighth.
double arc_up_to_one(double a) {
  const double eighths = nearest_whole(8 * a), c = eighths / 8;
  const Pair& arc = kArcs[static_cast<std::size_t>(eighths)];
  return arc.high + (arc.low + arc_near_zero((a - c) / (1 + a * c)));
}

// arctan a = π/2 - arctan(1/a), without the rounding of 1/a.
double arc_beyond_one(double a) {
  const double eighths = nearest_whole(8 / a), c = eighths / 8;
  const Pair& arc = kArcs[static_cast<std::size_t>(eighths)];
  const double high = kPi / 2 - arc.high;
  const double lost = (kPi / 2 - high) - arc.high;
  return high + ((lost + (kPiRest / 2 - arc.low)) - arc_near_zero((1 - c * a) / (a + c)));
}

// \pre a >= 0.
double arc(double a) {
  constexpr double kNearlyUpright = 0x1p60;
  if (a < kTiny) return a;
  if (a <= 1) return arc_up_to_one(a);
  return a > kNearlyUpright ? kPi / 2 : arc_beyond_one(a);
}

double power_of_two(int k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

constexpr double kLn2 = 0x1.62e42fefa2000p-1, kLn2Rest = 0x1.9ef35793c7673p-41;

}  // namespace

double sine(double x) {
  if (!std::isfinite(x)) return x - x;
  return std::abs(x) < kTiny ? x : sine_of(reduced(x), 0);
}

double cosine(double x) {
  if (!std::isfinite(x)) return x - x;
  return std::abs(x) < kTiny ? 1 : sine_of(reduced(x), 1);
}

double tangent(double x) {
  if (!std::isfinite(x)) return x - x;
  if (std::abs(x) < kTiny) return x;
  const QuarterTurns<double> r = reduced(x);
  const double s = sine_near_zero(r.high, r.low), c = cosine_near_zero(r.high, r.low);
  return is_odd(r.n) ? -c / s : s / c;
}

double arc_sine(double x) {
  if (std::abs(x) < kTiny) return x;
  return arc_tangent(x, std::sqrt((1 - x) * (1 + x)));
}

double arc_cosine(double x) {
  return arc_tangent(std::sqrt((1 - x) * (1 + x)), x);
}

double arc_tangent(double x) {
  return std::isnan(x) ? x : std::copysign(arc(std::abs(x)), x);
}

double arc_tangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const bool diagonal = std::isinf(x) && std::isinf(y);
  const bool nowhere = x == 0 && y == 0;
  const double slope = diagonal ? 1 : nowhere ? 0 : std::abs(y) / std::abs(x);
  const double angle = arc(slope);
  return std::copysign(std::signbit(x) ? kPi - (angle - kPiRest) : angle, y);
}

double exponential(double x) {
  constexpr double kHighest = 709.8, kLowest = -745.2;
  if (std::isnan(x)) return x;
  if (x > kHighest) return kInfinity;
  if (x < kLowest) return 0;
  const double k = nearest_whole(x * 0x1.71547652b82fep+0);
  const double a = x - k * kLn2, b = k * kLn2Rest;
  const double r = a - b, rest = (a - r) - b;
  // Taylor's series, for |r| <= ln(2)/2.
  double sum = 1.0 / 87178291200;
  for (const double term :
       {1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320,
        1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 1.0 / 2}) {
    sum = sum * r + term;
  }
  const int half = static_cast<int>(k) / 2;
  return (1 + (r + (rest + r * r * sum))) * power_of_two(half) *
         power_of_two(static_cast<int>(k) - half);
}

double natural_logarithm(double x) {
  if (std::isnan(x) || x < 0) return (x - x) / (x - x);
  if (x == 0) return -kInfinity;
  if (std::isinf(x)) return x;
  int exponent = 0;
  double part = std::frexp(x, &exponent);
  if (part < 0x1.6a09e667f3bcdp-1) {  // √½
    part *= 2;
    --exponent;
  }
  // ln(1 + f) = 2 artanh s with s = f/(2 + f), as f - (f²/2 - s(f²/2 + rest of the series)).
  const double f = part - 1, s = f / (2 + f), z = s * s, k = exponent;
  double sum = 2.0 / 23;
  for (const double term : {2.0 / 21, 2.0 / 19, 2.0 / 17, 2.0 / 15, 2.0 / 13, 2.0 / 11, 2.0 / 9,
                            2.0 / 7, 2.0 / 5, 2.0 / 3}) {
    sum = sum * z + term;
  }
  const double half = 0.5 * f * f;
  return k * kLn2 - ((half - (s * (half + z * sum) + k * kLn2Rest)) - f);
}

}  // namespace slipstick
