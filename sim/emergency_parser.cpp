#include "sim/emergency_parser.h"

#include <utility>

namespace slipstick {

namespace {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool ends_line(char c) {
  return c == '\n' || c == '\r';
}

/// M876 goes on to its word; the others are whole.
constexpr int kAnswerCode = 876;

std::optional<Emergency::Kind> kind_of(int code) {
  switch (code) {
    case 108:
      return Emergency::Kind::kContinue;
    case 112:
      return Emergency::Kind::kKill;
    case 410:
      return Emergency::Kind::kQuickStop;
    default:
      return std::nullopt;
  }
}

constexpr bool may_become_code(int digits) {
  for (const int code : {108, 112, 410, kAnswerCode}) {
    if (digits == code / 100 || digits == code / 10 || digits == code) return true;
  }
  return false;
}

}  // namespace

EmergencyParser::State EmergencyParser::code_after(char byte) {
  if (byte == ' ' && digits_ == 0) return State::kCode;
  if (!is_digit(byte)) return State::kIgnore;
  digits_ = 10 * digits_ + (byte - '0');
  if (digits_ == kAnswerCode) return State::kAnswer;
  if (const auto kind = kind_of(digits_)) {
    found_ = {*kind, 0};
    return State::kFound;
  }
  return may_become_code(digits_) ? State::kCode : State::kIgnore;
}

std::optional<Emergency> EmergencyParser::feed(char byte) {
  if (ends_line(byte)) {
    const bool found = std::exchange(state_, State::kStart) == State::kFound;
    return found ? std::optional(found_) : std::nullopt;
  }
  switch (state_) {
    case State::kStart:
    case State::kNumber:
      if (byte == 'M') {
        digits_ = 0;
        state_ = State::kCode;
      } else if (byte == 'N' && state_ == State::kStart) {
        state_ = State::kNumber;
      } else if (byte != ' ' && !(state_ == State::kNumber && (is_digit(byte) || byte == '-'))) {
        state_ = State::kIgnore;
      }
      break;
    case State::kCode:
      state_ = code_after(byte);
      break;
    case State::kAnswer:
      if (is_digit(byte)) {
        found_ = {Emergency::Kind::kAnswer, byte - '0'};
        state_ = State::kFound;
      } else if (byte != ' ' && byte != 'S') {
        state_ = State::kIgnore;
      }
      break;
    case State::kFound:
    case State::kIgnore:
      break;
  }
  return std::nullopt;
}

}  // namespace slipstick
