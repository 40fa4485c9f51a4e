#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace slipstick {

/// Bytes, in whatever pieces they come, to lines of bounded length.
///
/// A line ends at CR or LF; empty ones are dropped, and NULs, which an opening port produces. A
/// line longer than `kMaxLine` is dropped whole and counted.
class LineSplitter {
 public:
  /// The longest line Marlin says is M115's, about 300 bytes.
  static constexpr std::size_t kMaxLine = 1024;

  /// Hands over bytes; `next` must be drained before the next call.
  void feed(std::string_view bytes) { bytes_ = bytes; }

  /// The next complete line without its end; valid until the next call of either function.
  [[nodiscard]] std::optional<std::string_view> next();

  [[nodiscard]] std::uint64_t overlong() const { return overlong_; }

 private:
  std::string_view bytes_;
  std::string partial_;
  bool handed_over_ = false;
  bool skipping_ = false;
  std::uint64_t overlong_ = 0;
};

}  // namespace slipstick
