// What fits between two sides, from the ends of any chord through shapes of which it is known.
#include "core/region/facing.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"

using namespace slipstick;

namespace {

double uniform(Rng& rng, double low, double high) {
  return low + (high - low) * static_cast<double>(rng.below(1 << 20)) / (1 << 20);
}

Vec3 direction(Rng& rng) {
  while (true) {
    const Vec3 v{uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)};
    if (length(v) > 0.1 && length(v) < 1) return (1 / length(v)) * v;
  }
}

bool close(Vec3 a, Vec3 b) {
  return length(a - b) < 1e-9;
}

}  // namespace

TEST_CASE("Between parallel planes fits their distance, whichever axis the chord is along") {
  Rng rng(1);
  int found = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 normal = direction(rng);
    const Vec3 on_first{uniform(rng, -5, 5), uniform(rng, -5, 5), uniform(rng, -5, 5)};
    int seen = 0;
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      const double along = dot(axis, normal);
      if (std::abs(along) < 0.01) continue;
      const Vec3 on_last = on_first + (3 / along) * axis;

      const auto ball = ball_between({on_first, -1.0 * normal}, {on_last, normal});

      REQUIRE(ball.has_value() == (std::abs(along) >= kAlongMin));
      if (!ball) continue;
      ++seen;
      CHECK(ball->diameter == Approx(3));
      CHECK(close(ball->centre, 0.5 * (on_first + on_last)));
      CHECK(ball->squared_cosine == Approx(1));
    }
    CHECK(seen > 0);  // of three axes one always sees them
    found += seen;
  }
  CHECK(found >= 1000);
}

TEST_CASE("In a ball fits the ball, however far from its middle the chord is") {
  Rng rng(2);
  int found = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 centre{uniform(rng, -5, 5), uniform(rng, -5, 5), uniform(rng, -5, 5)};
    const double radius = uniform(rng, 0.1, 4);
    const Vec3 across = direction(rng);
    const Vec3 one = across;
    const Vec3 other{-across.x, across.y, across.z};

    const auto ball = ball_between({centre + radius * one, one}, {centre + radius * other, other});

    if (std::abs(across.x) < std::cos(15 * 3.14159265358979 / 180) - 1e-9) {
      CHECK_FALSE(ball);
      continue;
    }
    ++found;
    REQUIRE(ball);
    CHECK(ball->diameter == Approx(2 * radius));
    CHECK(close(ball->centre, centre));
  }
  CHECK(found > 10);
}

TEST_CASE("Between the sides of a wedge fits what touches both") {
  const double half = 5 * 3.14159265358979 / 180;  // of its angle
  const Vec3 up{-std::sin(half), std::cos(half), 0}, down{-std::sin(half), -std::cos(half), 0};
  const double distance = 10;  // from the edge, along each side
  const double c = std::cos(half), s = std::sin(half);

  const auto ball =
      ball_between({{distance * c, -distance * s, 0}, down}, {{distance * c, distance * s, 0}, up});

  REQUIRE(ball);
  CHECK(ball->diameter == Approx(2 * distance * std::tan(half)));
  CHECK(close(ball->centre, {distance / c, 0, 0}));
}

TEST_CASE("Sides at a right angle, and sides that look away, do not face each other") {
  const SurfacePoint west{{0, 0, 0}, {-1, 0, 0}};

  CHECK_FALSE(ball_between(west, {{1, 0, 0}, {0, 1, 0}}));
  CHECK_FALSE(ball_between(west, {{1, 0, 0}, {-1, 0, 0}}));
  CHECK_FALSE(ball_between(west, {{-1, 0, 0}, {1, 0, 0}}));
}
