#include "core/base/elementary.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/expr/graph.h"

using namespace slipstick;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Function {
  std::string name;
  double (*ours)(double);
  long double (*theirs)(long double);
  Op op;
};

const std::vector<Function>& functions() {
  static const std::vector<Function> all{
      {"sin", sine, std::sin, Op::kSin},          {"cos", cosine, std::cos, Op::kCos},
      {"tan", tangent, std::tan, Op::kTan},       {"asin", arc_sine, std::asin, Op::kAsin},
      {"acos", arc_cosine, std::acos, Op::kAcos}, {"atan", arc_tangent, std::atan, Op::kAtan},
      {"exp", exponential, std::exp, Op::kExp},   {"ln", natural_logarithm, std::log, Op::kLn},
  };
  return all;
}

// In units in the last place of a double near the true value.
double error_in_ulps(double ours, long double truth) {
  const auto nearest = static_cast<double>(truth);
  if (std::isnan(ours) && std::isnan(nearest)) return 0;
  if (std::isinf(nearest) || std::isinf(ours)) {
    return ours == nearest || std::abs(truth) > 0.999999999999L * DBL_MAX ? 0 : kInfinity;
  }
  const int exponent = std::max(std::ilogb(nearest == 0 ? DBL_TRUE_MIN : nearest), -1022);
  return static_cast<double>(
      std::abs((static_cast<long double>(ours) - truth) / std::ldexp(1.0L, exponent - 52)));
}

// All magnitudes, all numbers near one, small multiples of π/4 and their neighbours.
double argument(Rng& rng) {
  switch (rng.below(4)) {
    case 0:
      return std::bit_cast<double>(rng.next());
    case 1:
      return rng.unit() * 20 - 10;
    case 2:
      return (rng.unit() * 2 - 1) * std::exp2(static_cast<double>(rng.below(60)) - 40);
    default: {
      const double near = static_cast<double>(rng.below(1 << 22)) * 0.785398163397448310;
      return std::bit_cast<double>(std::bit_cast<std::uint64_t>(near) + rng.below(3));
    }
  }
}

int trials() {
  const char* more = std::getenv("SLIPSTICK_TRIALS");
  return 20'000 * (more ? std::max(1, std::atoi(more)) : 1);
}

}  // namespace

TEST_CASE("Elementary functions are within their bound of the C library's long doubles") {
  for (const Function& f : functions()) {
    Rng rng(7);
    double worst = 0, where = 0;
    for (int i = 0; i < trials(); ++i) {
      const double x = argument(rng);
      const double error = error_in_ulps(f.ours(x), f.theirs(x));
      if (error > worst) worst = error, where = x;
    }
    INFO(f.name << " at " << where);
    CHECK(worst <= kElementaryUlps);
    if (std::getenv("SLIPSTICK_TRIALS")) WARN(f.name << " is off by at most " << worst << " ulp");
  }
}

TEST_CASE("The angle of a point is within its bound in all quadrants") {
  Rng rng(8);
  double worst = 0;
  for (int i = 0; i < trials(); ++i) {
    const double y = argument(rng), x = argument(rng);
    const long double truth = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    worst = std::max(worst, error_in_ulps(arc_tangent(y, x), truth));
  }
  CHECK(worst <= kElementaryUlps);
}

TEST_CASE("Zeros, infinities and NaN are as in C") {
  const double values[] = {0.0, -0.0, 1, -1, kInfinity, -kInfinity, std::nan(""), 5e-324, -5e-324};
  const auto same = [](double a, double b) {
    return (std::isnan(a) && std::isnan(b)) ||
           (std::signbit(a) == std::signbit(b) && std::abs(a - b) <= 1e-15) || a == b;
  };
  for (const double x : values) {
    for (const Function& f : functions()) {
      INFO(f.name << " of " << x);
      CHECK(same(f.ours(x), static_cast<double>(f.theirs(x))));
    }
    for (const double y : values) {
      INFO(y << " over " << x);
      CHECK(same(arc_tangent(y, x), std::atan2(y, x)));
    }
  }
}

TEST_CASE("The hardest arguments to reduce are reduced exactly") {
  // The double nearest to a multiple of π/2 of all, and large ones. Values by 200-bit arithmetic.
  CHECK(cosine(0x1.6ac5b262ca1ffp+849) == -0x1.14ae72e6ba22fp-61);
  CHECK(sine(0x1p1023) == 0x1.205248cbdb760p-1);
  CHECK(cosine(1e22) == 0x1.0be2cef01c8f4p-1);
  CHECK(sine(DBL_MAX) == 0x1.452fc98b34e97p-8);
}

TEST_CASE("Elementary functions give the same bits on every machine", "[golden]") {
  std::uint64_t hash = 0;
  for (const Function& f : functions()) {
    Rng rng(9);
    for (int i = 0; i < 5000; ++i) {
      const double value = apply(f.op, argument(rng), 0);
      hash = (hash ^ (std::isnan(value) ? 1 : std::bit_cast<std::uint64_t>(value))) *
             0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
  }
  CHECK(hash == 0x99362a02dbdb5e30u);
}
