#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace slipstick {

/// \file
/// The header of a PLY file: what its body consists of.

enum class PlyFormat : std::uint8_t { kText, kLittleEndian, kBigEndian };
enum class PlyType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat,
  kDouble
};

/// Bytes of a binary value.
[[nodiscard]] std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat;
  std::optional<PlyType> count_type;  ///< Of lists.
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kText;
  std::vector<PlyElement> elements;
};

/// Takes the header off the front of `rest`. Every count fits the bytes that follow it.
[[nodiscard]] Result<PlyHeader> take_ply_header(std::string_view& rest);

}  // namespace slipstick
