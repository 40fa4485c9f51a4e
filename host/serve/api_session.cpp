// Accounts and sessions: the set-up, logging in and out, another password.
#include <fmt/format.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/passwords.h"
#include "host/serve/secrets.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t now() {
  return std::int64_t{std::time(nullptr)};
}

// For the page alone (HttpOnly: not even its scripts), sent along by no other site.
void set_cookie(HttpResponse& response, const HttpRequest& request, std::string_view token,
                std::chrono::seconds age) {
  response.headers.emplace_back(
      "Set-Cookie", fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict; Max-Age={}",
                                session_cookie_name(request.header("host")), token, age.count()));
}

// A new session in place of the one that was shown, so that no token outlives a login.
HttpResponse logged_in(const Accounts::User& user, const HttpRequest& request, Services& services) {
  if (request.caller.by == Caller::By::kSession) {
    const auto ended = services.accounts.end_session(request.caller.id);
    if (!ended) return error_response(ended.error());
  }
  const auto token = services.accounts.begin_session(user.id, now());
  if (!token) return error_response(token.error());
  HttpResponse response = json_response({{"user", user.name}});
  set_cookie(response, request, *token, Accounts::kAgeMost);
  return response;
}

HttpResponse logged_out(const HttpRequest& request, const Result<void>& ended) {
  if (!ended) return error_response(ended.error());
  HttpResponse response = empty_response();
  set_cookie(response, request, "", std::chrono::seconds(0));
  return response;
}

// Guesses are as slow as those of passwords.
std::optional<HttpResponse> refuse_code(const std::string& code, const std::string& address,
                                        LoginDesk& desk) {
  if (!desk.setup) return {};
  const auto time = std::chrono::steady_clock::now();
  const auto wait = desk.limiter.wait("", address, time);
  if (wait.count() > 0) return too_soon(wait);
  if (desk.setup->is(code)) {
    desk.limiter.succeeded("", address);
    return {};
  }
  desk.limiter.failed("", address, time);
  return error_response(403, "code: is not the one that slipstick told at its start");
}

HttpResponse make_first(const AccountName& name, const NewPassword& password,
                        const HttpRequest& request, Services& services) {
  const auto hash = password_hash(password.text());
  if (!hash) return error_response(hash.error());
  const auto user = services.accounts.add_first(name, *hash, now());
  if (!user) return error_response(user.error());
  if (!*user) return error_response(409, "there is an account already; log in");
  if (services.desk.setup) services.desk.setup->forget();
  return logged_in(**user, request, services);
}

}  // namespace

HttpResponse get_session(const HttpRequest& request, Services& services) {
  const Caller& caller = request.caller;
  const auto any = services.accounts.any();
  if (!any) return error_response(any.error());
  const bool known = caller.by != Caller::By::kNothing;
  const char* otherwise = *any ? "login" : "setup";
  return json_response({{"state", caller.by == Caller::By::kMachine ? "open"
                                  : known                           ? "in"
                                                                    : otherwise},
                        {"code", !*any && services.desk.setup.has_value()},
                        {"account", caller.by == Caller::By::kSession ? Json(caller.name) : Json()},
                        {"scope", known ? Json(name_of(caller.scope)) : Json()}});
}

HttpResponse post_setup(const HttpRequest& request, Services& services) {
  const auto any = services.accounts.any();
  if (!any) return error_response(any.error());
  if (*any) return error_response(409, "there is an account already; log in");
  const bool wants_code = services.desk.setup.has_value();
  Texts texts = wants_code ? texts_of(request, {"code", "name", "password"})
                           : texts_of(request, {"name", "password"});
  if (texts.refusal) return std::move(*texts.refusal);
  auto& values = texts.values;
  if (auto refusal = refuse_code(values["code"], request.peer, services.desk)) return *refusal;
  const auto name = AccountName::from(values["name"]);
  if (!name) return error_response(name.error());
  const auto password = NewPassword::from(values["password"], *name);
  if (!password) return error_response(password.error());
  return make_first(*name, *password, request, services);
}

HttpResponse post_login(const HttpRequest& request, Services& services) {
  Texts texts = texts_of(request, {"name", "password"});
  if (texts.refusal) return std::move(*texts.refusal);
  auto& values = texts.values;
  const auto user = services.accounts.find(values["name"]);
  if (!user) return error_response(user.error());
  auto refusal =
      refuse_password({values["name"], values["password"], request.peer}, *user, services.desk);
  return refusal ? *refusal : logged_in(**user, request, services);
}

HttpResponse post_logout(const HttpRequest& request, Services& services) {
  return logged_out(request, services.accounts.end_session(request.caller.id));
}

HttpResponse post_logout_everywhere(const HttpRequest& request, Services& services) {
  return logged_out(request, services.accounts.end_sessions(request.caller.user));
}

HttpResponse post_password(const HttpRequest& request, Services& services) {
  Texts texts = texts_of(request, {"old", "new"});
  if (texts.refusal) return std::move(*texts.refusal);
  const auto name = AccountName::from(request.caller.name);
  const auto password = name ? NewPassword::from(texts.values["new"], *name)
                             : Result<NewPassword>(fail(name.error()));
  Confirmed confirmed = confirm_password(request, texts.values["old"], services);
  if (confirmed.refusal) return std::move(*confirmed.refusal);
  if (!password) return error_response(password.error());
  const auto hash = password_hash(password->text());
  if (!hash) return error_response(hash.error());
  const auto changed = services.accounts.change_password(confirmed.user.id, *hash);
  if (!changed) return error_response(changed.error());
  return logged_in(confirmed.user, request, services);
}

}  // namespace slipstick
