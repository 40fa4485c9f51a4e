#pragma once

#include <cstdint>
#include <string_view>

namespace slipstick::test {

/// A hash of numbers and text, the same on every machine.
class BitHash {
 public:
  void add(std::uint64_t bits) {
    value_ = (value_ ^ bits) * 0x9E3779B97F4A7C15u;
    value_ ^= value_ >> 32;
  }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

}  // namespace slipstick::test
