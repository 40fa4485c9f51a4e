#include "core/contour/ledger.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/flood.h"
#include "tests/support/images.h"
#include "tests/support/stacks.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

Topology betti(std::int64_t components, std::int64_t tunnels, std::int64_t cavities) {
  return {components, tunnels, cavities};
}

// The shape under several slicing directions, under both rules.
void check_everywhere(const std::function<bool(Vec3)>& inside, int n, const Topology& expected) {
  for (const Vec3 turn : {Vec3{}, Vec3{90, 0, 0}, Vec3{0, 90, 0}, Vec3{31, 17, 5}}) {
    const Affine3 back = rotation_degrees(turn);
    const Stack stack = stack_of(n, [&](Vec3 p) { return inside(back(p)); });
    for (const Ambiguity rule : {Ambiguity::kSolid, Ambiguity::kVoid}) {
      const Topology found = ledger_of(stack, rule);
      CAPTURE(turn.x, turn.y, found.components, found.tunnels, found.cavities);
      CHECK(found == expected);
    }
  }
}

bool in_torus(Vec3 p, double ring, double tube) {
  return std::hypot(std::hypot(p.x, p.y) - ring, p.z) <= tube;
}

// Steps of the Menger sponge: a cell is left out where two of its ternary digits are 1.
bool in_sponge(Vec3 p, int steps) {
  auto cell = [steps](double v) {
    return static_cast<int>(std::floor((v + 1) / 2 * std::pow(3, steps)));
  };
  int x = cell(p.x), y = cell(p.y), z = cell(p.z);
  for (int s = 0; s < steps; ++s, x /= 3, y /= 3, z /= 3) {
    if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("The ledger of random stacks is that of a flood fill in space", "[ledger]") {
  Rng rng(9);
  for (int round = 0; round < 150; ++round) {
    const int n = 1 + static_cast<int>(rng.below(9));
    const double density = rng.unit();
    Stack stack;
    for (int k = 0; k < n; ++k) stack.push_back(noise(rng, n, n, density));
    for (const Ambiguity rule : {Ambiguity::kSolid, Ambiguity::kVoid}) {
      CAPTURE(round, n, density);
      CHECK(ledger_of(stack, rule) == flooded(stack, rule));
    }
  }
}

TEST_CASE("The ledger of a wide stack is that of a flood fill", "[ledger]") {
  Rng rng(10);  // rows of more than one word
  const Stack stack{noise(rng, 150, 7, 0.4), noise(rng, 150, 7, 0.5), noise(rng, 150, 7, 0.6)};

  CHECK(ledger_of(stack, Ambiguity::kSolid) == flooded(stack, Ambiguity::kSolid));
  CHECK(ledger_of(stack, Ambiguity::kVoid) == flooded(stack, Ambiguity::kVoid));
}

TEST_CASE("A single layer has the components and holes of its image", "[ledger]") {
  Rng rng(11);
  for (int round = 0; round < 100; ++round) {
    const BitImage image = structured(rng);

    CHECK(ledger_of({image}, Ambiguity::kSolid) == betti(components(image, 8), holes(image, 4), 0));
    CHECK(ledger_of({image}, Ambiguity::kVoid) == betti(components(image, 4), holes(image, 8), 0));
  }
}

TEST_CASE("Nothing has no topology", "[ledger]") {
  CHECK(StackLedger(Ambiguity::kSolid).topology() == betti(0, 0, 0));
  CHECK(ledger_of(stack_of(3, [](Vec3) { return false; }), Ambiguity::kVoid) == betti(0, 0, 0));
}

TEST_CASE("Known solids have their Betti numbers in every slicing direction", "[ledger]") {
  check_everywhere([](Vec3 p) { return length(p) <= 0.8; }, 24, betti(1, 0, 0));
  check_everywhere([](Vec3 p) { return std::abs(length(p) - 0.65) <= 0.15; }, 24, betti(1, 0, 1));
  check_everywhere([](Vec3 p) { return in_torus(p, 0.6, 0.25); }, 28, betti(1, 1, 0));
  check_everywhere(
      [](Vec3 p) {
        return std::abs(p.x) < 0.5 && std::abs(p.y) < 0.5 && std::abs(p.z) < 0.5 &&
               std::hypot(p.x, p.y) > 0.2;
      },
      28, betti(1, 1, 0));
}

TEST_CASE("Linked tori are two components with a tunnel each", "[ledger]") {
  const auto linked = [](Vec3 p) {
    return in_torus({p.x + 0.25, p.y, p.z}, 0.5, 0.14) ||
           in_torus({p.x - 0.25, p.z, p.y}, 0.5, 0.14);
  };
  check_everywhere(linked, 40, betti(2, 2, 0));
}

TEST_CASE("Steps of the Menger sponge have 5 and 81 tunnels", "[ledger]") {
  const auto sponge = [](int steps) {
    const int n = static_cast<int>(std::pow(3, steps));
    return stack_of(n, [steps](Vec3 p) { return in_sponge(p, steps); });
  };
  for (const Ambiguity rule : {Ambiguity::kSolid, Ambiguity::kVoid}) {
    CHECK(ledger_of(sponge(1), rule) == betti(1, 5, 0));
    CHECK(ledger_of(sponge(2), rule) == betti(1, 81, 0));
  }
}

TEST_CASE("A piece of gyroid has the same topology from all sides and at half the width",
          "[ledger]") {
  const auto piece = [](Vec3 p) {
    const Vec3 q = 1.6 * std::numbers::pi * p;
    const double g = std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) +
                     std::sin(q.z) * std::cos(q.x);
    return std::pow(g / 0.7, 2) + std::pow(length(p) / 0.9, 8) <= 1;  // no edges, so no slivers
  };
  const Topology expected = flooded(stack_of(60, piece), Ambiguity::kSolid);

  REQUIRE(expected.tunnels > 3);
  check_everywhere(piece, 60, expected);
  CHECK(ledger_of(stack_of(120, piece), Ambiguity::kSolid) == expected);
}

TEST_CASE("Cells that share a corner with the next layer follow the rule of the print",
          "[ledger]") {
  const Stack corner{image_of({"#.", ".."}), image_of({"..", ".#"})};

  CHECK(ledger_of(corner, Ambiguity::kSolid) == betti(1, 0, 0));
  CHECK(ledger_of(corner, Ambiguity::kVoid) == betti(2, 0, 0));
}
