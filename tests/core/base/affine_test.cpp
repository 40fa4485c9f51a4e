#include "core/base/affine.h"

#include <catch2/catch.hpp>

using namespace slipstick;

TEST_CASE("A rotation by right angles is exact") {
  const Affine3 turn = rotation_degrees({0, 0, 90});

  CHECK(turn({1, 2, 3}) == Vec3{-2, 1, 3});
}

TEST_CASE("The inverse undoes a map") {
  const Affine3 map = composed(translation({1, 2, 3}),
                               composed(rotation_degrees({10, 20, 30}), scaling({2, 3, 4})));

  const Vec3 back = inverse(map)(map({5, 6, 7}));

  CHECK(back.x == Approx(5));
  CHECK(back.y == Approx(6));
  CHECK(back.z == Approx(7));
}

TEST_CASE("The slicing direction becomes z") {
  for (const Vec3 d : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 1, 1}, Vec3{0, -2, 0}}) {
    const Vec3 turned = rotation_to_z(d)(d);

    CHECK(turned.x == Approx(0).margin(1e-12));
    CHECK(turned.y == Approx(0).margin(1e-12));
    CHECK(turned.z == Approx(length(d)));
  }
}
