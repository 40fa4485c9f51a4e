#include "core/formats/inflate.h"

#include <algorithm>
#include <limits>

#include "core/base/check.h"

namespace slipstick {
namespace {

// zlib's interface does not promise to leave its input alone.
Bytef* bytes_of(std::string_view text) {
  // NOLINTNEXTLINE: zlib's bytes are unsigned and not const
  return const_cast<Bytef*>(reinterpret_cast<const Bytef*>(text.data()));
}

}  // namespace

std::string deflated(std::string_view bytes) {
  z_stream stream{};
  SLIPSTICK_CHECK(deflateInit(&stream, Z_DEFAULT_COMPRESSION) == Z_OK);
  std::string result;
  std::array<char, 1 << 16> piece{};
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
  int status = Z_OK;
  while (status != Z_STREAM_END) {
    if (stream.avail_in == 0) {
      const std::size_t size = std::min(bytes.size(), kMost);
      stream.next_in = bytes_of(bytes);
      stream.avail_in = static_cast<uInt>(size);
      bytes.remove_prefix(size);
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());  // NOLINT: zlib's bytes
    stream.avail_out = static_cast<uInt>(piece.size());
    status = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    result.append(piece.data(), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return result;
}

Inflater::Inflater(std::string_view compressed) : rest_(compressed) {
  SLIPSTICK_CHECK(inflateInit(&stream_) == Z_OK);
}

Inflater::~Inflater() {
  inflateEnd(&stream_);
}

std::optional<std::uint8_t> Inflater::next() {
  if (at_ == end_) refill();
  if (at_ == end_) return {};
  return piece_[at_++];
}

void Inflater::refill() {
  at_ = end_ = 0;
  if (complete_ || failed_) return;
  stream_.next_out = piece_.data();
  stream_.avail_out = static_cast<uInt>(piece_.size());
  while (stream_.avail_out > 0) {
    if (stream_.avail_in == 0) {
      const std::size_t size =
          std::min<std::size_t>(rest_.size(), std::numeric_limits<uInt>::max());
      stream_.next_in = bytes_of(rest_);
      stream_.avail_in = static_cast<uInt>(size);
      rest_.remove_prefix(size);
    }
    const int status = inflate(&stream_, Z_NO_FLUSH);
    complete_ = status == Z_STREAM_END && rest_.empty() && stream_.avail_in == 0;
    failed_ = status != Z_OK && !complete_;
    if (status != Z_OK) break;
  }
  end_ = piece_.size() - stream_.avail_out;
}

}  // namespace slipstick
