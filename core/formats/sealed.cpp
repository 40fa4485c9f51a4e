#include "core/formats/sealed.h"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>

#include "core/base/check.h"

namespace slipstick {
namespace {

constexpr std::size_t kHeadSize = kMagicSize + 4 + 8;
constexpr std::size_t kTailSize = 4;

template <typename T>
void append_bits(std::string& body, T bits) {
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    body += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  }
}

template <typename T>
T take_bits(std::string_view& rest) {
  SLIPSTICK_CHECK(rest.size() >= sizeof(T));
  T bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bits |= static_cast<T>(static_cast<T>(static_cast<unsigned char>(rest[i])) << (8 * i));
  }
  rest.remove_prefix(sizeof(T));
  return bits;
}

std::uint32_t checksum(std::string_view bytes) {
  // NOLINTNEXTLINE: zlib's bytes are unsigned
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(0, data, bytes.size()));
}

}  // namespace

std::string seal(const SealedKind& kind, std::string_view body) {
  SLIPSTICK_CHECK(kind.magic.size() == kMagicSize);
  std::string bytes(kind.magic);
  bytes.reserve(kHeadSize + body.size() + kTailSize);
  append_u32(bytes, kind.version);
  append_u64(bytes, body.size());
  bytes += body;
  append_u32(bytes, checksum(bytes));
  return bytes;
}

Result<std::string_view> unseal(const SealedKind& kind, std::string_view bytes) {
  if (!bytes.starts_with(kind.magic)) {
    return fail(ErrorCode::kInput,
                fmt::format("does not begin with \"{}\"; is the extension right?", kind.magic));
  }
  if (bytes.size() < kHeadSize + kTailSize) {
    return fail(ErrorCode::kInput, "ends within its head; it is cut short, make it again");
  }
  std::string_view rest = bytes.substr(kMagicSize);
  const std::uint32_t version = take_u32(rest);
  if (version != kind.version) {
    return fail(ErrorCode::kInput, fmt::format("has version {}, this program reads version {}; "
                                               "convert the model again",
                                               version, kind.version));
  }
  const std::uint64_t size = take_u64(rest);
  if (size != rest.size() - kTailSize) {
    return fail(ErrorCode::kInput, fmt::format("says {} bytes but has {}; it is cut short or "
                                               "damaged, make it again",
                                               size, rest.size() - kTailSize));
  }
  std::string_view tail = rest.substr(rest.size() - kTailSize);
  if (take_u32(tail) != checksum(bytes.substr(0, bytes.size() - kTailSize))) {
    return fail(ErrorCode::kInput, "has a wrong checksum; it is damaged, make it again");
  }
  return rest.substr(0, rest.size() - kTailSize);
}

void append_u32(std::string& body, std::uint32_t value) {
  append_bits(body, value);
}
void append_u64(std::string& body, std::uint64_t value) {
  append_bits(body, value);
}
void append_f64(std::string& body, double value) {
  append_bits(body, std::bit_cast<std::uint64_t>(value));
}

std::uint32_t take_u32(std::string_view& rest) {
  return take_bits<std::uint32_t>(rest);
}
std::uint64_t take_u64(std::string_view& rest) {
  return take_bits<std::uint64_t>(rest);
}
double take_f64(std::string_view& rest) {
  return std::bit_cast<double>(take_bits<std::uint64_t>(rest));
}

}  // namespace slipstick
