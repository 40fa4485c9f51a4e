#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// The name of an account, or of a key: 1 to 64 bytes without control characters, and without
/// blanks at its ends.
class AccountName {
 public:
  static constexpr std::size_t kBytesMax = 64;

  /// \return kInput says what is wrong with it.
  [[nodiscard]] static Result<AccountName> from(std::string_view text);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  explicit AccountName(std::string_view text) : text_(text) {}
  std::string text_;
};

/// A password that may be given to an account. All of it counts, whatever is in it.
class NewPassword {
 public:
  static constexpr std::size_t kCharactersMin = 10;
  static constexpr std::size_t kBytesMax = 1024;

  /// \return kInput says what is wrong with it.
  [[nodiscard]] static Result<NewPassword> from(std::string_view text, const AccountName& account);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  explicit NewPassword(std::string_view text) : text_(text) {}
  std::string text_;
};

}  // namespace slipstick
