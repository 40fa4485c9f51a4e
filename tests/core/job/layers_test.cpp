#include "core/job/layers.h"

#include <catch2/catch.hpp>

using namespace slipstick;

namespace {

LayerStack stack_of(double height, double first, double each) {
  SlicingSettings settings;
  settings.first_layer_height = first;
  settings.layer_height = each;
  return *LayerStack::over(height, settings);
}

}  // namespace

TEST_CASE("Each layer is cut in its middle and the first may be thicker") {
  const LayerStack stack = stack_of(40, 0.3, 0.2);

  CHECK(stack.middle(0) == Approx(0.15));
  CHECK(stack.top(0) == Approx(0.3));
  CHECK(stack.middle(1) == Approx(0.4));
  CHECK(stack.top(1) == Approx(0.5));
}

TEST_CASE("The last middle lies below the top of the solid, the next would not") {
  for (const double height : {0.05, 0.1, 0.31, 1.0, 40.0, 40.05}) {
    const LayerStack stack = stack_of(height, 0.2, 0.2);
    INFO(height);

    CHECK(stack.count() >= 1);
    if (stack.count() > 1) CHECK(stack.middle(stack.count() - 1) < height + 1e-9);
    CHECK(stack.middle(stack.count()) >= height - 1e-9);
  }
}

TEST_CASE("Too many layers are an error that says what to change") {
  SlicingSettings settings;
  settings.layer_height = 0.001;

  const auto stack = LayerStack::over(1000, settings);

  REQUIRE_FALSE(stack);
  CHECK(stack.error().code == ErrorCode::kInput);
  CHECK_THAT(stack.error().message, Catch::Contains("--layer-height"));
}
