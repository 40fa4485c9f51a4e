#pragma once

#include <cstdint>
#include <string_view>

namespace slipstick {

/// What becomes of a line that was received.
enum class Verdict : std::uint8_t {
  kAccepted,
  kDuplicate,  ///< Dropped without a word (new in Marlin 2.1.2).
  kWrongNumber,
  kWrongChecksum,
  kNoChecksum,
};

/// Line numbers and checksums in the order in which Marlin 2.1.2 looks at them.
///
/// The number comes first: a line whose number was damaged is never told about its checksum, and
/// `M110` anywhere in the text switches the number check off.
class LineGate {
 public:
  /// Judges `line` and, if it is numbered and accepted, takes its number as the last one.
  Verdict judge(std::string_view line);

  [[nodiscard]] std::int64_t last_number() const { return last_number_; }
  /// What M110 N… does when it is executed.
  void set_last_number(std::int64_t number) { last_number_ = number; }

 private:
  std::int64_t last_number_ = 0;
};

/// The text between "Error:" and the last number. \pre `verdict` is one of the three errors.
[[nodiscard]] std::string_view error_text(Verdict verdict);

}  // namespace slipstick
