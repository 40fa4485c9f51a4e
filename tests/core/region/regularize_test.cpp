#include "core/region/regularize.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/images.h"

using namespace slipstick;
using namespace slipstick::test;

namespace {

using Stack = std::vector<BitImage>;
using Step = BitImage (*)(std::span<const BitImage* const>, const DiscreteBall&);

// Every layer of the stack, and those above and below it that the ball reaches.
Stack applied(Step step, const Stack& stack, const DiscreteBall& ball) {
  const int reach = ball.reach(), count = static_cast<int>(stack.size());
  const BitImage empty(stack[0].grid());
  Stack result;
  for (int layer = 0; layer < count; ++layer) {
    std::vector<const BitImage*> window;
    for (int k = layer - reach; k <= layer + reach; ++k) {
      window.push_back(k < 0 || k >= count ? &empty : &stack[static_cast<std::size_t>(k)]);
    }
    result.push_back(step(window, ball));
  }
  return result;
}

// One node at a time, by the definition.
bool touched(const Stack& stack, const DiscreteBall& ball, int column, int row, int layer,
             bool inside) {
  const double h = stack[0].grid().width();
  const int across = static_cast<int>(ball.radius / h) + 1, reach = ball.reach();
  for (int dz = -reach; dz <= reach; ++dz) {
    for (int dy = -across; dy <= across; ++dy) {
      for (int dx = -across; dx <= across; ++dx) {
        const double z = dz * ball.spacing;
        if (dx * h * dx * h + dy * h * dy * h + z * z > ball.radius * ball.radius) continue;
        const int k = layer + dz;
        const bool in = k >= 0 && k < static_cast<int>(stack.size()) &&
                        stack[static_cast<std::size_t>(k)].at(column + dx, row + dy);
        if (in == inside) return true;
      }
    }
  }
  return false;
}

// Room of `margin` nodes and layers around noise in blocks.
Stack random_stack(Rng& rng, int margin) {
  constexpr int kSide = 20;
  const BitImage empty(small_grid(kSide + 2 * margin, kSide + 2 * margin));
  Stack stack(static_cast<std::size_t>(10 + 2 * margin), empty);
  for (int blob = 0; blob < 14; ++blob) {
    const int x = static_cast<int>(rng.below(14)), y = static_cast<int>(rng.below(14)),
              z = static_cast<int>(rng.below(8)), size = 1 + static_cast<int>(rng.below(6));
    for (int k = z; k < std::min(z + size, 10); ++k) {
      for (int r = y; r < y + size; ++r) {
        for (int c = x; c < x + size; ++c) {
          stack[static_cast<std::size_t>(k + margin)].set(c + margin + 2, r + margin + 2, true);
        }
      }
    }
  }
  return stack;
}

Stack opened(const Stack& stack, const DiscreteBall& ball) {
  return applied(dilated, applied(eroded, stack, ball), ball);
}
Stack closed(const Stack& stack, const DiscreteBall& ball) {
  return applied(eroded, applied(dilated, stack, ball), ball);
}

bool within(const Stack& a, const Stack& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](const BitImage& x, const BitImage& y) { return !(x - y).any(); });
}

// 0.125 mm is a node: discs of radius 0, 1, 2.2 and 3 nodes.
const std::vector<DiscreteBall> kBalls{{0, 0.2}, {0.125, 0.125}, {0.28, 0.1}, {0.375, 0.2}};

}  // namespace

TEST_CASE("Growing and shrinking by a ball are what their definition says at every node") {
  Rng rng(41);
  for (const DiscreteBall& ball : kBalls) {
    const Stack stack = random_stack(rng, 4);
    const Stack grown = applied(dilated, stack, ball), shrunk = applied(eroded, stack, ball);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < stack.size(); ++k) {
      for (int row = 1; row < stack[k].rows() - 1; ++row) {
        for (int column = 1; column < stack[k].columns() - 1; ++column) {
          const int layer = static_cast<int>(k);
          wrong += grown[k].at(column, row) != touched(stack, ball, column, row, layer, true);
          wrong += shrunk[k].at(column, row) == touched(stack, ball, column, row, layer, false);
        }
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("Opening only removes, closing only adds, and twice is once") {
  Rng rng(42);
  for (const DiscreteBall& ball : kBalls) {
    const Stack stack = random_stack(rng, 8);
    const Stack open = opened(stack, ball), close = closed(stack, ball);
    CHECK(within(open, stack));
    CHECK(within(stack, close));
    CHECK(opened(open, ball) == open);
    CHECK(closed(close, ball) == close);
  }
}

TEST_CASE("Opening removes a fin thinner than the ball, closing fills a slit") {
  const DiscreteBall ball{0.25, 0.125};
  Stack stack(20, BitImage(small_grid(40, 40)));
  for (std::size_t k = 6; k < 14; ++k) {
    for (int r = 10; r < 30; ++r) {
      for (int c = 10; c < 30; ++c) {
        if (c != 20) stack[k].set(c, r, true);
      }
    }
    for (int c = 30; c < 36; ++c) stack[k].set(c, 20, true);
  }
  CHECK(closed(stack, ball)[10].at(20, 20));
  CHECK_FALSE(opened(stack, ball)[10].at(33, 20));
  CHECK(opened(stack, ball)[10].at(15, 20));
}
