#include "host/serve/credentials.h"

#include <fmt/format.h>

#include <algorithm>

namespace slipstick {
namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7f;
}

// Of UTF-8: bytes that do not go on with the one before.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

Result<AccountName> AccountName::from(std::string_view text) {
  if (text.empty()) return fail(ErrorCode::kInput, "name: is empty");
  if (text.size() > kBytesMax) {
    return fail(ErrorCode::kInput, fmt::format("name: is longer than {} bytes", kBytesMax));
  }
  if (std::ranges::any_of(text, is_control)) {
    return fail(ErrorCode::kInput, "name: has control characters");
  }
  if (text.front() == ' ' || text.back() == ' ') {
    return fail(ErrorCode::kInput, "name: begins or ends with a blank");
  }
  return AccountName(text);
}

Result<NewPassword> NewPassword::from(std::string_view text, const AccountName& account) {
  if (characters(text) < kCharactersMin) {
    return fail(ErrorCode::kInput,
                fmt::format("password: must have at least {} characters", kCharactersMin));
  }
  if (text.size() > kBytesMax) {
    return fail(ErrorCode::kInput, fmt::format("password: is longer than {} bytes", kBytesMax));
  }
  if (text == account.text()) {
    return fail(ErrorCode::kInput, "password: must not be the name");
  }
  return NewPassword(text);
}

}  // namespace slipstick
