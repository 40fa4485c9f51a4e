#pragma once

#include <optional>
#include <string>

#include "host/serve/accounts.h"
#include "host/serve/http.h"

namespace slipstick {

/// What a route asks of who asks for it.
enum class RouteAccess : std::uint8_t {
  kAnyone,  ///< The page and what leads into it: the same for all.
  kRead,    ///< Who has that scope; likewise the others.
  kPrint,
  kControl,
  kAdmin,
  kAccount,  ///< Who is logged in: no key will do.
};

/// From where the daemon can be reached.
enum class Reach : std::uint8_t { kMachine, kNetwork };

/// Who may ask. Everybody needs a key or a session, but on the loopback address as long as no
/// account was made: then everybody on the machine may, but no web page of another site (the
/// browser would send its requests from here). Nothing that a client says about where it comes from
/// is believed.
///
/// Requests by a session that change anything must have been sent by the page itself: the browser
/// proves it (`Origin`, `Sec-Fetch-Site`). Keys are no browser's, and need no such proof.
///
/// Threads: any, each with accounts of its own.
class AccessRules {
 public:
  /// \param key that of the data folder, an administrator's; empty: none.
  AccessRules(Reach reach, std::string key) : reach_(reach), key_(std::move(key)) {}

  struct Verdict {
    Caller caller = {};
    std::optional<HttpResponse> refusal = {};  ///< 401: who? 403: not you.
  };
  /// Who asks, and whether he may. \param now seconds since 1970.
  [[nodiscard]] Verdict check(RouteAccess needed, const HttpRequest& head, Accounts& accounts,
                              std::int64_t now) const;

 private:
  struct Shown {
    std::string key;
    std::string session;
  };
  [[nodiscard]] Result<Caller> identify(const Shown& shown, Accounts& accounts,
                                        std::int64_t now) const;

  const Reach reach_;
  const std::string key_;
};

/// What the cookie of a session is called. Browsers give the cookies of a host to all its ports,
/// and several daemons on one machine must not log each other out. \param host the header Host:
/// "printer.lan:5000".
[[nodiscard]] std::string session_cookie_name(std::string_view host);

}  // namespace slipstick
