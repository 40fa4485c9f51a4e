#include "host/serve/secrets.h"

#include <sodium.h>

#include <array>

#include "core/base/check.h"

namespace slipstick {
namespace {

constexpr std::size_t kTokenBytes = 32;

// Has to come before any other call; only the first one works.
void prepare() {
  SLIPSTICK_CHECK(sodium_init() >= 0);
}

std::string hexadecimal(const std::array<unsigned char, kTokenBytes>& bytes) {
  std::array<char, 2 * kTokenBytes + 1> text{};
  return sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
}

}  // namespace

std::string random_token() {
  prepare();
  std::array<unsigned char, kTokenBytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return hexadecimal(bytes);
}

std::string random_code(std::size_t size) {
  constexpr std::string_view kLetters = "23456789ABCDEFGHJKLMNPQRSTUVWXYZ";
  static_assert(kLetters.size() == 32);
  prepare();
  std::string code;
  while (code.size() < size) code += kLetters[randombytes_uniform(kLetters.size())];
  return code;
}

std::string token_hash(std::string_view token) {
  prepare();
  std::array<unsigned char, kTokenBytes> hash{};
  const auto* bytes = reinterpret_cast<const unsigned char*>(token.data());
  SLIPSTICK_CHECK(crypto_generichash(hash.data(), hash.size(), bytes, token.size(), nullptr, 0) ==
                  0);
  return hexadecimal(hash);
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  return a.size() == b.size() && sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

Result<std::string> password_hash(std::string_view password) {
  prepare();
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  if (crypto_pwhash_str(hash.data(), password.data(), password.size(),
                        crypto_pwhash_OPSLIMIT_INTERACTIVE,
                        crypto_pwhash_MEMLIMIT_INTERACTIVE) == 0) {
    return std::string(hash.data());
  }
  return fail(ErrorCode::kUnavailable, "there is no memory to hash the password; try again");
}

bool password_matches(const std::string& hash, std::string_view password) {
  prepare();
  // The library may read as many bytes as the longest hash has.
  std::array<char, crypto_pwhash_STRBYTES> text{};
  hash.copy(text.data(), text.size() - 1);
  return crypto_pwhash_str_verify(text.data(), password.data(), password.size()) == 0;
}

const std::string& hash_of_nobody() {
  static const std::string kHash =
      "$argon2id$v=19$m=65536,t=2,p=1$3KNowYBBjPSS1d1V+8Wh0Q$VxN5Iq11ocabO7FWQERsWFCHdoazBiaYmxL/"
      "YyzFeO0";
  return kHash;
}

}  // namespace slipstick
