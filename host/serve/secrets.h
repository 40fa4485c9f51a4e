#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// \file
/// Tokens by chance, and hashes of tokens and passwords, by libsodium. Threads: any.

/// 256 bits by chance, as 64 hexadecimal digits.
[[nodiscard]] std::string random_token();

/// A text by chance, of letters and digits that are not taken for others: 5 bits each.
[[nodiscard]] std::string random_code(std::size_t size);

/// What is kept of a token: 64 hexadecimal digits, from which it cannot be found. Without salt, as
/// tokens are made by chance and need none.
[[nodiscard]] std::string token_hash(std::string_view token);

/// The same time for all texts of one size, whatever they differ in.
[[nodiscard]] bool equal_in_constant_time(std::string_view a, std::string_view b);

/// What is kept of a password: Argon2id with a salt of its own. Takes 64 MiB, and from a tenth of a
/// second to a second, depending on the machine. \return kUnavailable if there is no memory.
[[nodiscard]] Result<std::string> password_hash(std::string_view password);

/// Takes as long, and as much memory. \return whether `hash` was made from `password`.
[[nodiscard]] bool password_matches(const std::string& hash, std::string_view password);

/// A hash that takes as long as any other and was made from 256 bits that nobody knows: what is
/// compared with where there is no such user, so that the time does not tell.
[[nodiscard]] const std::string& hash_of_nobody();

}  // namespace slipstick
