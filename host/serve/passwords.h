#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <string>

#include "host/serve/routes.h"

namespace slipstick {

/// \file
/// What the routes of accounts have in common. Threads: that of slow routes.

/// The members of a body, all of which are texts; or the refusal, which says what is wrong.
struct Texts {
  std::map<std::string, std::string> values = {};
  std::optional<HttpResponse> refusal = {};
};
/// \param names all that there must be, and no others.
[[nodiscard]] Texts texts_of(const HttpRequest& request, std::initializer_list<const char*> names);

/// 429: the next try is looked at in so long.
[[nodiscard]] HttpResponse too_soon(LoginLimiter::Seconds wait);

struct PasswordTry {
  std::string account;
  std::string password;
  std::string address;  ///< As `http_peer` counts it.
};
/// The refusal (403, 429) unless it is the password of `user`, which may be nobody: the same answer
/// after the same time.
[[nodiscard]] std::optional<HttpResponse> refuse_password(const PasswordTry& tried,
                                                          const std::optional<Accounts::User>& user,
                                                          LoginDesk& desk);

/// The account that is logged in, if `password` is its; or the refusal.
struct Confirmed {
  Accounts::User user = {};
  std::optional<HttpResponse> refusal = {};
};
[[nodiscard]] Confirmed confirm_password(const HttpRequest& request, const std::string& password,
                                         Services& services);

}  // namespace slipstick
