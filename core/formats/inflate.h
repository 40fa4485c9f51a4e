#pragma once

#include <zlib.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace slipstick {

/// `bytes` compressed by zlib.
[[nodiscard]] std::string deflated(std::string_view bytes);

/// Reads compressed bytes piece by piece, in bounded memory however much they come to.
class Inflater {
 public:
  /// \pre `compressed` outlives this.
  explicit Inflater(std::string_view compressed);
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater();

  /// Nothing at the end and where the bytes are damaged.
  [[nodiscard]] std::optional<std::uint8_t> next();
  /// Whether the end was reached as it was written.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  void refill();

  std::string_view rest_;
  z_stream stream_{};
  std::array<std::uint8_t, 1 << 16> piece_{};
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  bool complete_ = false;
  bool failed_ = false;
};

}  // namespace slipstick
