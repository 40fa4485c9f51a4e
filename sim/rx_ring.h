#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace slipstick {

/// The ring that the serial interrupt fills: 128 bytes of which one always stays empty.
class RxRing {
 public:
  static constexpr std::size_t kSize = 128;
  static constexpr std::size_t kUsable = kSize - 1;

  [[nodiscard]] bool empty() const { return head_ == tail_; }
  [[nodiscard]] std::size_t room() const { return kUsable - (head_ - tail_) % kSize; }

  /// False where the ring is full: the byte is lost.
  bool push(char byte) {
    if (room() == 0) return false;
    bytes_[head_] = byte;
    head_ = (head_ + 1) % kSize;
    return true;
  }

  std::optional<char> pop() {
    if (empty()) return std::nullopt;
    const char byte = bytes_[tail_];
    tail_ = (tail_ + 1) % kSize;
    return byte;
  }

  void clear() { tail_ = head_; }

 private:
  std::array<char, kSize> bytes_{};
  std::size_t head_ = 0;
  std::size_t tail_ = 0;
};

}  // namespace slipstick
