#include "host/serve/access.h"

#include <fmt/format.h>

#include "host/serve/secrets.h"

namespace slipstick {
namespace {

// Of "localhost:5000", "[::1]:5000".
std::string_view without_port(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  const bool is_port = colon != std::string_view::npos && host.find(']', colon) == host.npos;
  return is_port ? host.substr(0, colon) : host;
}

// A name like 127.0.0.1.example.org may point anywhere.
bool is_local(std::string_view host) {
  return host == "localhost" || host == "[::1]" ||
         (host.starts_with("127.") && host.find_first_not_of("0123456789.") == host.npos);
}

// The host of "http://localhost:5000".
std::string_view host_of_origin(std::string_view origin) {
  const std::size_t at = origin.find("://");
  return at == std::string_view::npos ? origin : origin.substr(at + 3);
}

bool is_of_another_site(const HttpRequest& head) {
  const std::string& origin = head.header("origin");
  return !origin.empty() && host_of_origin(origin) != head.header("host");
}

// Whether the browser says that the page of this very origin sent it.
bool is_proved_to_be_ours(const HttpRequest& head) {
  return !head.header("origin").empty() || head.header("sec-fetch-site") == "same-origin";
}

bool is_for_octoprint(const HttpRequest& head) {
  const auto& path = head.target.path;
  return !path.empty() &&
         (path[0] == "sockjs" || (path[0] == "api" && path.size() > 1 && path[1] != "v1"));
}

// Programs for OctoPrint show theirs in the address where they can send no header.
std::string key_shown(const HttpRequest& head) {
  constexpr std::string_view kBearer = "Bearer ";
  if (!head.header("x-api-key").empty()) return head.header("x-api-key");
  const std::string& authorization = head.header("authorization");
  if (authorization.starts_with(kBearer)) return authorization.substr(kBearer.size());
  const auto asked = head.target.query.find("apikey");
  const bool in_address = is_for_octoprint(head) && head.method == HttpMethod::kGet;
  return in_address && asked != head.target.query.end() ? asked->second : "";
}

// The value of the cookie, or empty.
std::string cookie(std::string_view cookies, const std::string& name) {
  const std::string start = name + "=";
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    const std::string_view each = cookies.substr(0, end);
    if (each.starts_with(start)) return std::string(each.substr(start.size()));
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    while (cookies.starts_with(' ')) cookies.remove_prefix(1);
  }
  return {};
}

// OctoPrint's clients want 403 where no key is shown.
HttpResponse who_is_that(const HttpRequest& head, bool there_are_accounts) {
  constexpr const char* kNone = "there is no account yet: open this address in a browser";
  constexpr const char* kSome = "log in, or show a key in the header X-Api-Key";
  auto refusal =
      error_response(is_for_octoprint(head) ? 403 : 401, there_are_accounts ? kSome : kNone);
  refusal.headers.emplace_back("WWW-Authenticate", "Bearer realm=\"slipstick\"");
  return refusal;
}

std::optional<HttpResponse> refusal_for(RouteAccess needed, const Caller& caller) {
  if (needed == RouteAccess::kAccount) {
    if (caller.by == Caller::By::kSession) return {};
    return error_response(403, "this is for whoever is logged in, not for keys");
  }
  const auto scope = static_cast<Scope>(static_cast<int>(needed) - 1);
  static_assert(static_cast<int>(RouteAccess::kAdmin) - 1 == static_cast<int>(Scope::kAdmin));
  if (caller.scope >= scope) return {};
  return error_response(403, fmt::format("this needs a key for \"{}\"; the one shown is for \"{}\"",
                                         name_of(scope), name_of(caller.scope)));
}

}  // namespace

std::string session_cookie_name(std::string_view host) {
  const std::string_view name = without_port(host);
  std::string port(host.substr(name.size()));
  std::erase_if(port, [](char c) { return c < '0' || c > '9'; });
  return "slipstick" + port;
}

Result<Caller> AccessRules::identify(const Shown& shown, Accounts& accounts,
                                     std::int64_t now) const {
  Result<std::optional<Caller>> found = std::optional<Caller>();
  if (!shown.key.empty()) {
    // Hashes are of one size, whatever was shown.
    const bool is_file_key =
        !key_.empty() && equal_in_constant_time(token_hash(shown.key), token_hash(key_));
    if (is_file_key) return Caller{Caller::By::kFileKey, Scope::kAdmin, 0, 0, "api_key"};
    found = accounts.key(shown.key, now);
  } else if (!shown.session.empty()) {
    found = accounts.session(shown.session, now);
  }
  if (!found) return fail(found.error());
  return found->value_or(Caller{});
}

AccessRules::Verdict AccessRules::check(RouteAccess needed, const HttpRequest& head,
                                        Accounts& accounts, std::int64_t now) const {
  // A page of another site, or a name of another site that was made to point here.
  if (is_of_another_site(head)) {
    return {{}, error_response(403, "requests from pages of other sites are not answered")};
  }
  const auto there_are_accounts = accounts.any();
  if (!there_are_accounts) return {{}, error_response(there_are_accounts.error())};
  if (reach_ == Reach::kMachine && !*there_are_accounts) {
    if (is_local(without_port(head.header("host")))) {
      return {{Caller::By::kMachine, Scope::kAdmin, 0, 0, ""}, {}};
    }
    return {{}, error_response(403, "without an account only requests to localhost are answered")};
  }
  const Shown shown{key_shown(head),
                    cookie(head.header("cookie"), session_cookie_name(head.header("host")))};
  const auto caller = identify(shown, accounts, now);
  if (!caller) return {{}, error_response(caller.error())};
  if (needed == RouteAccess::kAnyone) return {*caller, {}};
  if (caller->by == Caller::By::kNothing) return {{}, who_is_that(head, *there_are_accounts)};
  if (caller->by == Caller::By::kSession && head.method != HttpMethod::kGet &&
      !is_proved_to_be_ours(head)) {
    return {{}, error_response(403, "the browser must say that its request is from this page")};
  }
  return {*caller, refusal_for(needed, *caller)};
}

}  // namespace slipstick
