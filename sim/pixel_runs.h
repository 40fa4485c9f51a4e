#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace slipstick {

/// Calls visit(begin, end) for each run of set pixels of a row of `columns`, or of clear ones.
template <typename Visit>
void for_runs(std::span<const std::uint64_t> words, int columns, std::uint64_t invert,
              Visit visit) {
  constexpr int kWordBits = 64;
  int begin = -1;  // Of the run we are in; -1 between runs.
  for (std::size_t w = 0; w < words.size(); ++w) {
    std::uint64_t word = words[w] ^ invert;
    const int base = static_cast<int>(w) * kWordBits;
    int at = 0;
    while (at < kWordBits) {
      const std::uint64_t rest = (begin < 0 ? word : ~word) >> at;
      if (rest == 0) break;
      at += std::countr_zero(rest);
      if (begin < 0) {
        begin = base + at;
      } else {
        visit(begin, std::min(base + at, columns));
        begin = -1;
      }
    }
  }
  if (begin >= 0 && begin < columns) visit(begin, columns);
}

template <typename Visit>
void for_set_runs(std::span<const std::uint64_t> words, int columns, Visit visit) {
  for_runs(words, columns, 0, visit);
}

}  // namespace slipstick
