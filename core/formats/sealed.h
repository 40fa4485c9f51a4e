#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// \file
/// The envelope of our own binary files: what it is, its version, its length, and a checksum, so
/// that damage is told from everything else before a number of it is believed.
///
/// Layout, little endian: `kMagicSize` bytes of magic, u32 version, u64 bytes of the body, the
/// body, u32 CRC-32 (the one of zlib) of all before it.

inline constexpr std::size_t kMagicSize = 8;

/// What kind of file is meant. \pre `magic` has `kMagicSize` characters.
struct SealedKind {
  std::string_view magic;
  std::uint32_t version;
};

[[nodiscard]] std::string seal(const SealedKind& kind, std::string_view body);

/// The body within `bytes`. \return kInput for another kind or version, for missing or surplus
/// bytes and for a wrong checksum; the message does not name the file.
[[nodiscard]] Result<std::string_view> unseal(const SealedKind& kind, std::string_view bytes);

/// Numbers of a body, little endian.
void append_u32(std::string& body, std::uint32_t value);
void append_u64(std::string& body, std::uint64_t value);
void append_f64(std::string& body, double value);

/// \pre `rest` has enough bytes.
[[nodiscard]] std::uint32_t take_u32(std::string_view& rest);
[[nodiscard]] std::uint64_t take_u64(std::string_view& rest);
[[nodiscard]] double take_f64(std::string_view& rest);

}  // namespace slipstick
