#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/number_text.h"
#include "core/formats/mesh_ply_header.h"
#include "core/formats/mesh_words.h"

namespace slipstick {

/// The values of the body of a PLY file, one after the other.
class PlyValues {
 public:
  PlyValues(PlyFormat format, std::string_view body) : format_(format), rest_(body) {}

  /// Nothing at the end and, in text, where there is no number.
  std::optional<double> next(PlyType type) {
    if (format_ == PlyFormat::kText) return parse_number(take_word(rest_));
    const std::size_t size = size_of(type);
    if (rest_.size() < size) return {};
    std::array<char, 8> bytes{};
    const auto end = std::copy_n(rest_.begin(), size, bytes.begin());
    constexpr bool kHostIsLittle = std::endian::native == std::endian::little;
    if ((format_ == PlyFormat::kLittleEndian) != kHostIsLittle) std::reverse(bytes.begin(), end);
    rest_.remove_prefix(size);
    return decoded(bytes, type);
  }

 private:
  template <typename T>
  static double value_of(std::array<char, 8> bytes) {
    std::array<char, sizeof(T)> exact;
    std::copy_n(bytes.begin(), sizeof(T), exact.begin());
    return static_cast<double>(std::bit_cast<T>(exact));
  }

  static double decoded(std::array<char, 8> bytes, PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return value_of<std::int8_t>(bytes);
      case PlyType::kUint8:
        return value_of<std::uint8_t>(bytes);
      case PlyType::kInt16:
        return value_of<std::int16_t>(bytes);
      case PlyType::kUint16:
        return value_of<std::uint16_t>(bytes);
      case PlyType::kInt32:
        return value_of<std::int32_t>(bytes);
      case PlyType::kUint32:
        return value_of<std::uint32_t>(bytes);
      case PlyType::kFloat:
        return value_of<float>(bytes);
      case PlyType::kDouble:
        return value_of<double>(bytes);
    }
    return 0;
  }

  PlyFormat format_;
  std::string_view rest_;
};

}  // namespace slipstick
