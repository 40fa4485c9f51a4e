#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// What the first account is made with where the daemon can be reached from other machines: only
/// who can read the terminal, the system's log or the data folder knows it, so that nobody else on
/// the network is there first.
///
/// Threads: any, `forget` aside.
class SetupCode {
 public:
  /// The code in `path`, made by chance (60 bits) if there is none yet; readable by its owner only.
  /// \return kUnavailable if it can be neither read nor made.
  [[nodiscard]] static Result<SetupCode> load_or_make(const std::filesystem::path& path);

  /// "K7QF-9XTM-2HRW".
  [[nodiscard]] const std::string& text() const { return text_; }
  /// In letters of any case, with or without dashes and blanks.
  [[nodiscard]] bool is(std::string_view typed) const;
  /// Removes the file.
  void forget() const;

 private:
  SetupCode(std::filesystem::path path, std::string text)
      : path_(std::move(path)), text_(std::move(text)) {}

  std::filesystem::path path_;
  std::string text_;
};

}  // namespace slipstick
