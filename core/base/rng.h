#pragma once

#include <cstdint>

namespace slipstick {

/// A small seeded generator (splitmix64, Steele et al. 2014): the same numbers on every machine.
class Rng {
 public:
  explicit constexpr Rng(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// 0 ≤ result < bound. \pre bound > 0. Slightly biased for bounds near 2^64; we use small ones.
  constexpr std::uint64_t below(std::uint64_t bound) { return next() % bound; }

  /// 0 ≤ result < 1.
  constexpr double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace slipstick
