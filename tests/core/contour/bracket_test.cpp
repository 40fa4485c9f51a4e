// Closing in on a crossing by values: always closes, on the pair where the sign changes, and soon
// where f is smooth.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/rng.h"
#include "core/contour/bracket.h"
#include "core/contour/place_roots.h"
#include "core/contour/trace.h"
#include "core/image/sample.h"

using namespace slipstick;

namespace {

constexpr int kEnd = 65536;

struct Closed {
  std::int32_t inside;
  int looks;
};

template <typename F>
Closed close(F f) {
  Bracket bracket(f(0), f(kEnd));
  int looks = 0;
  while (!bracket.closed()) {
    REQUIRE(looks < Bracket::kLooksMax);
    const std::int32_t at = bracket.next();
    bracket.take(f(at));
    ++looks;
  }
  return {bracket.inside(), looks};
}

// An egg about the origin, with values or with membership only.
class Egg final : public Section {
 public:
  explicit Egg(bool has_values) : has_values_(has_values) {}

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override {
    for (std::size_t i = 0; i < xs.size(); ++i) inside[i] = f(xs[i], ys[i]) <= 0 ? 1 : 0;
  }
  bool evaluate(std::span<const double> xs, std::span<const double> ys,
                std::span<double> values) override {
    if (!has_values_) return false;
    for (std::size_t i = 0; i < xs.size(); ++i) values[i] = f(xs[i], ys[i]);
    return true;
  }
  Narrowed narrowed(const Box2&) override { return {}; }

 private:
  static double f(double x, double y) { return x * x + y * y * (1 + x / 9) - 9; }

  bool has_values_;
};

}  // namespace

TEST_CASE("A bracket closes on a change of sign, whatever the values between") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    std::map<std::int32_t, double> values;
    const auto f = [&](std::int32_t k) {
      double& value = values.try_emplace(k, kNan).first->second;
      constexpr double kOdd[] = {0, -0.0, 1e-310, -1e-310, 1e308, -1e308, kInfinity, -kInfinity};
      if (std::isnan(value)) value = rng.below(2) == 0 ? rng.unit() - 0.5 : kOdd[rng.below(8)];
      if (k == 0) value = -std::abs(value);
      if (k == kEnd) value = rng.below(4) == 0 ? kNan : std::abs(value) + 1e-300;
      return value;
    };

    const std::int32_t inside = close(f).inside;

    REQUIRE(values.at(inside) <= 0);
    REQUIRE(!(values.at(inside + 1) <= 0));
  }
}

TEST_CASE("Where f is monotone the bracket is the one that halving finds") {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    const double root = rng.unit() * kEnd, power = 0.2 + 4 * rng.unit();
    const auto f = [&](std::int32_t k) {
      return std::copysign(std::pow(std::abs(k - root), power), k - root);
    };

    REQUIRE(close(f).inside == static_cast<std::int32_t>(root));
  }
}

TEST_CASE("Smooth values close a bracket in five looks, four on average") {
  constexpr int kCases = 2000;
  int sum = 0;
  for (std::uint64_t seed = 0; seed < kCases; ++seed) {
    INFO("seed " << seed);
    Rng rng(seed);
    // A slope of one that changes by up to a half along the stick: chords alone need eight.
    const double root = rng.unit(), bend = 0.5 * (rng.unit() - 0.5), cube = 0.1 * rng.unit();
    const auto f = [&](std::int32_t k) {
      const double t = static_cast<double>(k) / kEnd - root;
      return t + bend * t * t + cube * t * t * t;
    };

    const int looks = close(f).looks;

    REQUIRE(looks <= 5);
    sum += looks;
  }
  CHECK(sum < 4 * kCases);
}

TEST_CASE("Roots by values are those by membership") {
  Egg values(true), membership(false);
  const auto grid = SliceGrid::over({{-4, -4}, {4, 4}}, 0.0625);
  ContourSet by_values = trace(*sample(values, *grid), Ambiguity::kSolid);
  ContourSet by_membership = by_values;

  place_roots(by_values, values);
  place_roots(by_membership, membership);

  REQUIRE(by_values.places().size() > 300);
  CHECK(std::equal(by_values.places().begin(), by_values.places().end(),
                   by_membership.places().begin()));
}
