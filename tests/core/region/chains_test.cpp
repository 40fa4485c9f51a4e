#include "core/region/chains.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/images.h"

using namespace slipstick;

namespace {

bool beside(Node a, Node b) {
  return !(a == b) && std::abs(a.column - b.column) <= 1 && std::abs(a.row - b.row) <= 1;
}

}  // namespace

TEST_CASE("Chains are unbroken and hold every node of the lines") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Rng rng(seed);
    const BitImage thin = test::noise(rng, 20, 20, 0.35);
    const BitImage kept = thin & test::noise(rng, 20, 20, 0.2);
    BitImage seen(thin.grid());
    INFO("seed " << seed);

    for (const Chain& chain : chains_of(thin, kept)) {
      for (std::size_t i = 0; i < chain.nodes.size(); ++i) {
        seen.set(chain.nodes[i].column, chain.nodes[i].row, true);
        if (i > 0) REQUIRE(beside(chain.nodes[i - 1], chain.nodes[i]));
      }
      if (chain.closed) REQUIRE(beside(chain.nodes.front(), chain.nodes.back()));
    }

    CHECK((thin - kept - seen).any() == false);
  }
}

TEST_CASE("A ring is one closed chain, a cross is four, a speck is one node") {
  const auto chains = [&](const std::vector<std::string>& picture) {
    const BitImage image = test::image_of(picture);
    return chains_of(image, BitImage(image.grid()));
  };

  const auto ring = chains({".##.", "#..#", "#..#", ".##."});
  REQUIRE(ring.size() == 1);
  CHECK(ring[0].closed);
  CHECK(ring[0].nodes.size() == 8);

  CHECK(chains({"..#..", "..#..", "#####", "..#..", "..#.."}).size() == 4);

  const auto speck = chains({"...", ".#.", "..."});
  REQUIRE(speck.size() == 1);
  CHECK(speck[0].nodes.size() == 1);
}
