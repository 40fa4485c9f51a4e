#pragma once

#include <cstdint>
#include <optional>

namespace slipstick {

/// What the emergency parser obeys.
struct Emergency {
  enum class Kind : std::uint8_t {
    kContinue,   ///< M108
    kKill,       ///< M112
    kQuickStop,  ///< M410
    kAnswer,     ///< M876 S and one digit
  };

  Kind kind{};
  int answer = 0;  ///< 0 to 9, of kAnswer.

  friend bool operator==(const Emergency&, const Emergency&) = default;
};

/// Marlin's EMERGENCY_PARSER (2.1.2): looks at each byte as it arrives, before any buffer. A code
/// counts at the start of a line or behind a line number, and acts at the line's end, whatever else
/// stands behind it.
class EmergencyParser {
 public:
  [[nodiscard]] std::optional<Emergency> feed(char byte);

 private:
  enum class State : std::uint8_t { kStart, kNumber, kCode, kAnswer, kFound, kIgnore };

  [[nodiscard]] State code_after(char byte);

  State state_ = State::kStart;
  int digits_ = 0;  ///< Of the code behind M, as a number.
  Emergency found_;
};

}  // namespace slipstick
