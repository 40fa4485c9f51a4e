#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/vec.h"

namespace slipstick {

/// A direction, coarsely: three whole numbers, the largest of them ±511, in one word. Never zero.
class LdniNormal {
 public:
  static constexpr int kLargest = 511;

  /// Up.
  LdniNormal() : LdniNormal(0, 0, kLargest) {}
  /// \return nothing if `direction` is zero or not finite.
  [[nodiscard]] static std::optional<LdniNormal> of(Vec3 direction);
  /// \return nothing if the word is none of a normal.
  [[nodiscard]] static std::optional<LdniNormal> from_word(std::uint32_t word);

  [[nodiscard]] std::uint32_t word() const { return word_; }
  /// Along x, y or z.
  [[nodiscard]] int along(std::size_t axis) const {
    return static_cast<int>((word_ >> (kBits * axis)) & kMask) - kOffset;
  }

  friend bool operator==(const LdniNormal&, const LdniNormal&) = default;

 private:
  static constexpr unsigned kBits = 10;
  static constexpr std::uint32_t kMask = (1u << kBits) - 1;
  static constexpr int kOffset = 1 << (kBits - 1);

  LdniNormal(int x, int y, int z) : word_(part(x, 0) | part(y, 1) | part(z, 2)) {}
  [[nodiscard]] static constexpr std::uint32_t part(int value, unsigned axis) {
    return static_cast<std::uint32_t>(value + kOffset) << (kBits * axis);
  }

  std::uint32_t word_;
};

}  // namespace slipstick
