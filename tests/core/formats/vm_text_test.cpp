#include "core/formats/vm_text.h"

#include <catch2/catch.hpp>

using namespace slipstick;
using Catch::Contains;

namespace {

const Box3 kBounds{{-2, -2, -2}, {2, 2, 2}};

bool inside(std::string_view text, Vec3 p) {
  const auto model = load_vm_model(text, "test.vm", kBounds);
  if (!model) FAIL(model.error().message);
  std::uint8_t result = 2;
  (*model)->placed({})->section(p.z)->classify({&p.x, 1}, {&p.y, 1}, {&result, 1});
  return result == 1;
}

std::string refusal(std::string_view text) {
  const auto model = load_vm_model(text, "test.vm", kBounds);
  REQUIRE_FALSE(model);
  return model.error().message;
}

}  // namespace

TEST_CASE("The last statement is the solid, comments and blanks do not matter") {
  const char* text =
      "# a half plane\r\n"
      "  # another comment\r\n"
      "\r\n"
      "_0 var-x\r\n"
      "one const 1.0  extra words\r\n"
      "  _1 sub _0 one\r\n";

  CHECK(inside(text, {0.5, 0, 0}));
  CHECK_FALSE(inside(text, {1.5, 0, 0}));
}

TEST_CASE("Inside is below 0, 0 itself is outside") {
  CHECK_FALSE(inside("a var-x\n", {0, 0, 0}));
  CHECK(inside("a var-x\n", {-1e-300, 0, 0}));
  CHECK_FALSE(inside("a const 0\n", {0, 0, 0}));
}

TEST_CASE("Constants are 32-bit") {
  CHECK(inside("x var-x\nc const 0.1\nf sub x c\n", {0.1000000001, 0, 0}));
}

TEST_CASE("A name may be bound again") {
  CHECK(inside("a const 1\na const -1\n", {0, 0, 0}));
}

TEST_CASE("Mistakes in an expression are told with their line") {
  CHECK_THAT(refusal("a var-x\nb neg c\n"), Contains("test.vm:2:") && Contains("'c'"));
  CHECK_THAT(refusal("a rand\n"), Contains("rand"));
  CHECK_THAT(refusal("a mix\n"), Contains("mix"));
  CHECK_THAT(refusal("a const x\n"), Contains("number"));
  CHECK_THAT(refusal("a var-x\nb add a\n"), Contains("2 operands"));
  CHECK_THAT(refusal("a\n"), Contains("test.vm:1:"));
  CHECK_THAT(refusal("# nothing\n"), Contains("no statement"));
}
