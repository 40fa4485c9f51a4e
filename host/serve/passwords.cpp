#include "host/serve/passwords.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/serve/secrets.h"

namespace slipstick {

Texts texts_of(const HttpRequest& request, std::initializer_list<const char*> names) {
  const auto json = parse_json(request.body);
  const auto refuse = [](const std::string& what) { return Texts{{}, error_response(400, what)}; };
  if (!json.is_object()) return refuse("the body must be a JSON object");
  Texts texts;
  for (const char* name : names) {
    const auto at = json.find(name);
    if (at == json.end() || !at->is_string())
      return refuse(fmt::format("{}: must be a text", name));
    texts.values.emplace(name, at->get<std::string>());
  }
  for (const auto& [name, value] : json.items()) {
    if (!texts.values.contains(name)) return refuse(fmt::format("{}: is not known", name));
  }
  return texts;
}

HttpResponse too_soon(LoginLimiter::Seconds wait) {
  auto response =
      error_response(429, fmt::format("too many wrong passwords; try again in {} s", wait.count()));
  response.headers.emplace_back("Retry-After", std::to_string(wait.count()));
  return response;
}

std::optional<HttpResponse> refuse_password(const PasswordTry& tried,
                                            const std::optional<Accounts::User>& user,
                                            LoginDesk& desk) {
  const auto wait =
      desk.limiter.wait(tried.account, tried.address, std::chrono::steady_clock::now());
  if (wait.count() > 0) return too_soon(wait);
  const bool matches = password_matches(user ? user->password : hash_of_nobody(), tried.password);
  if (user && matches) {
    desk.limiter.succeeded(tried.account, tried.address);
    return {};
  }
  desk.limiter.failed(tried.account, tried.address, std::chrono::steady_clock::now());
  return error_response(403, "name or password is wrong");
}

Confirmed confirm_password(const HttpRequest& request, const std::string& password,
                           Services& services) {
  if (request.caller.by != Caller::By::kSession) {
    return {{}, error_response(409, "there is no account yet; make one first")};
  }
  const auto user = services.accounts.find(request.caller.name);
  if (!user) return {{}, error_response(user.error())};
  auto refusal =
      refuse_password({request.caller.name, password, request.peer}, *user, services.desk);
  if (refusal) return {{}, std::move(refusal)};
  return {**user, {}};
}

}  // namespace slipstick
