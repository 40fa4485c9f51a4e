#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace slipstick {

/// MeatPack (protocol PV01) as Marlin 2.1.2 unpacks it: two characters a byte from an alphabet of
/// fifteen. Off until a host turns it on; a reset turns it off.
class MeatPack {
 public:
  /// The characters that `byte` completes, valid until the next call. What is not packed passes as
  /// it is.
  [[nodiscard]] std::span<const char> feed(char byte);

  /// What is said about the last commands, whole lines.
  [[nodiscard]] std::string take_text();

 private:
  void obey(std::uint8_t command);
  void pass(std::uint8_t byte);
  void unpack(std::uint8_t byte);
  void literal(char byte);
  void emit(char c) { out_[count_++] = c; }
  [[nodiscard]] char unpacked(unsigned nibble) const;

  bool on_ = false;
  bool no_spaces_ = false;
  int signals_ = 0;   ///< Bytes 0xFF in a row: two of them begin a command.
  int literals_ = 0;  ///< Characters that follow as they are.
  char second_ = 0;   ///< Packed, and due behind one of them; 0 is none.
  std::array<char, 4> out_{};
  std::size_t count_ = 0;
  std::string text_;
};

}  // namespace slipstick
