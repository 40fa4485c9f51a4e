#include "sim/meat_pack.h"

#include <utility>

namespace slipstick {

namespace {

constexpr std::string_view kAlphabet = "0123456789. \nGX";
constexpr unsigned kSpace = 11;
constexpr unsigned kLiteral = 15;
constexpr std::uint8_t kSignal = 0xFF;

enum Command : std::uint8_t {
  kSpacesOn = 0xF6,
  kSpacesOff = 0xF7,
  kQuery = 0xF8,
  kResetAll = 0xF9,
  kOff = 0xFA,
  kOn = 0xFB,
};

}  // namespace

char MeatPack::unpacked(unsigned nibble) const {
  return nibble == kSpace && no_spaces_ ? 'E' : kAlphabet[nibble];
}

void MeatPack::obey(std::uint8_t command) {
  switch (command) {
    case kOn:
      on_ = true;
      break;
    case kOff:
      on_ = false;
      break;
    case kResetAll:
      on_ = no_spaces_ = false;
      break;
    case kSpacesOff:
      no_spaces_ = true;
      break;
    case kSpacesOn:
      no_spaces_ = false;
      break;
    case kQuery:
      break;
    default:
      return;
  }
  text_.append("[MP] PV01 ").append(on_ ? "ON" : "OFF").append(no_spaces_ ? " NSP\n" : " ESP\n");
}

void MeatPack::literal(char byte) {
  emit(byte);
  --literals_;
  if (second_ != 0) emit(std::exchange(second_, '\0'));
}

void MeatPack::unpack(std::uint8_t byte) {
  const unsigned first = byte & 0x0FU;
  const unsigned second = byte >> 4U;
  if (first == kLiteral) {
    literals_ = second == kLiteral ? 2 : 1;
    second_ = second == kLiteral ? '\0' : unpacked(second);
    return;
  }
  emit(unpacked(first));
  if (unpacked(first) == '\n') return;  // What shares a byte with a line end only fills it up.
  if (second == kLiteral) {
    literals_ = 1;
  } else {
    emit(unpacked(second));
  }
}

void MeatPack::pass(std::uint8_t byte) {
  if (!on_) {
    emit(static_cast<char>(byte));
  } else if (literals_ > 0) {
    literal(static_cast<char>(byte));
  } else {
    unpack(byte);
  }
}

std::span<const char> MeatPack::feed(char byte) {
  const auto value = static_cast<std::uint8_t>(byte);
  count_ = 0;
  if (signals_ == 2) {
    signals_ = 0;
    obey(value);
    return {out_.data(), count_};
  }
  if (value == kSignal && literals_ == 0) {
    ++signals_;  // One says that two literals follow, or is half the way to a command.
    return {out_.data(), count_};
  }
  if (std::exchange(signals_, 0) == 1) pass(kSignal);
  pass(value);
  return {out_.data(), count_};
}

std::string MeatPack::take_text() {
  return std::exchange(text_, {});
}

}  // namespace slipstick
