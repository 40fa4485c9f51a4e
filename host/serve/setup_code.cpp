#include "host/serve/setup_code.h"

#include <fmt/format.h>

#include "host/serve/api_key.h"
#include "host/serve/secrets.h"

namespace slipstick {
namespace {

constexpr std::size_t kGroup = 4;
constexpr std::size_t kLetters = 3 * kGroup;

std::string new_code() {
  const std::string letters = random_code(kLetters);
  return fmt::format("{}-{}-{}", letters.substr(0, kGroup), letters.substr(kGroup, kGroup),
                     letters.substr(2 * kGroup));
}

std::string letters_of(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (c == '-' || c == ' ') continue;
    letters += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return letters;
}

}  // namespace

Result<SetupCode> SetupCode::load_or_make(const std::filesystem::path& path) {
  auto text = load_or_make_secret(path, kLetters, new_code);
  if (!text) return fail(text.error());
  return SetupCode(path, std::move(*text));
}

bool SetupCode::is(std::string_view typed) const {
  return equal_in_constant_time(letters_of(typed), letters_of(text_));
}

void SetupCode::forget() const {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace slipstick
