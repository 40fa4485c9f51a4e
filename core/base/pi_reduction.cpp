#include "core/base/pi_reduction.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/check.h"

namespace slipstick {
namespace {

__extension__ typedef unsigned __int128 Wide;  // what ISO C++ has no name for

// The first 1280 bits of 2/π behind the binary point.
constexpr std::array<std::uint64_t, 20> kTwoOverPi{
    0xA2F9836E4E441529u, 0xFC2757D1F534DDC0u, 0xDB6295993C439041u, 0xFE5163ABDEBBC561u,
    0xB7246E3A424DD2E0u, 0x06492EEA09D1921Cu, 0xFE1DEB1CB129A73Eu, 0xE88235F52EBB4484u,
    0xE99C7026B45F7E41u, 0x3991D639835339F4u, 0x9C845F8BBDF9283Bu, 0x1FF897FFDE05980Fu,
    0xEF2F118B5A0A6D1Fu, 0x6D367ECF27CB09B7u, 0x4F463F669E5FEA2Du, 0x7527BAC7EBE5F17Bu,
    0x3D0739F78A5292EAu, 0x6BFB5FB11F8D5D08u, 0x56033046FC7B6BABu, 0xF0CFBC209AF4361Du};

// A fraction of 256 bits, most significant word first.
using Fraction = std::array<std::uint64_t, 4>;

std::uint64_t word_at(int bit) {
  const auto word = [](int i) {
    return i < 0 || i >= static_cast<int>(kTwoOverPi.size())
               ? std::uint64_t{0}
               : kTwoOverPi[static_cast<std::size_t>(i)];
  };
  const int index = bit >= 0 ? bit / 64 : -((63 - bit) / 64), shift = bit - index * 64;
  return shift == 0 ? word(index) : word(index) << shift | word(index + 1) >> (64 - shift);
}

// whole · 2/π · 2^exponent modulo 4, in units of 2^-254.
Fraction turns(std::uint64_t whole, int exponent) {
  Fraction result{};
  Wide carry = 0;
  for (int i = 3; i >= 0; --i) {
    // Bits of 2/π that weigh 4 or more make whole turns and are left out.
    carry += Wide{word_at(exponent - 2 + 64 * i)} * whole;
    result[static_cast<std::size_t>(i)] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  return result;
}

Fraction shifted_left(const Fraction& f, int bits) {
  Fraction result{};
  const auto words = static_cast<std::size_t>(bits / 64);
  const int rest = bits % 64;
  for (std::size_t i = 0; i + words < f.size(); ++i) {
    result[i] = f[i + words] << rest;
    if (rest != 0 && i + words + 1 < f.size()) result[i] |= f[i + words + 1] >> (64 - rest);
  }
  return result;
}

Fraction negated(Fraction f) {
  bool carry = true;
  for (std::size_t i = f.size(); i-- > 0;) {
    f[i] = ~f[i] + (carry ? 1 : 0);
    carry = carry && f[i] == 0;
  }
  return f;
}

struct Pair {
  double high;
  double low;
};

// The fraction times π/2. Dekker's product: without a fused multiply-add anywhere.
Pair angle_of(const Fraction& f) {
  int zeros = 0;
  while (zeros < 192 && f[static_cast<std::size_t>(zeros / 64)] == 0) zeros += 64;
  zeros += std::countl_zero(f[static_cast<std::size_t>(zeros / 64)]);
  const Fraction bits = shifted_left(f, zeros);
  const double a = std::ldexp(static_cast<double>(bits[0] >> 11), -53 - zeros);
  const double rest =
      std::ldexp(static_cast<double>((bits[0] << 53 | bits[1] >> 11) >> 11), -106 - zeros);
  constexpr double kHalfPi = 0x1.921fb54442d18p+0, kHalfPiRest = 0x1.1a62633145c07p-54;
  constexpr double kSplit = 0x1p27 + 1;
  constexpr double kTop = kHalfPi * kSplit - (kHalfPi * kSplit - kHalfPi);
  constexpr double kBottom = kHalfPi - kTop;
  const double top = a * kSplit - (a * kSplit - a), bottom = a - top;
  const double product = a * kHalfPi;
  const double lost = ((top * kTop - product) + top * kBottom + bottom * kTop) + bottom * kBottom;
  const double low = lost + (a * kHalfPiRest + rest * kHalfPi);
  const double high = product + low;
  return {high, (product - high) + low};
}

}  // namespace

QuarterTurns<double> reduce_exactly(double x) {
  SLIPSTICK_DCHECK(std::isfinite(x) && x != 0);
  int exponent = 0;
  const double part = std::frexp(std::abs(x), &exponent);
  const Fraction all = turns(static_cast<std::uint64_t>(std::ldexp(part, 53)), exponent - 53);
  double n = static_cast<double>(all[0] >> 62);
  Fraction rest = shifted_left(all, 2);
  const bool back = rest[0] >> 63 != 0;
  if (back) {
    rest = negated(rest);
    n += 1;
  }
  const Pair angle = angle_of(rest);
  const double sign = x < 0 ? -1 : 1, way = back ? -sign : sign;
  return {sign * n, way * angle.high, way * angle.low};
}

}  // namespace slipstick
