// Programs that ask for a key: OctoPrint's /plugin/appkeys for them, /api/v1/app-requests for who
// decides. A key that is given is one like all others.
#include <ctime>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/octoprint.h"
#include "host/serve/passwords.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

AppRequests::Moment now() {
  return std::chrono::steady_clock::now();
}

// Where nobody has an account, nobody needs a key.
std::optional<HttpResponse> refuse_without_accounts(Services& services) {
  const auto any = services.accounts.any();
  if (!any) return error_response(any.error());
  if (*any) return {};
  return error_response(404, "no key is needed here");
}

HttpResponse no_such_request() {
  return error_response(404, "nobody waits for that any more");
}

}  // namespace

HttpResponse octo_appkeys_probe(const HttpRequest&, Services& services) {
  auto refusal = refuse_without_accounts(services);
  return refusal ? *std::move(refusal) : empty_response();
}

HttpResponse octo_appkeys_request(const HttpRequest& request, Services& services) {
  if (auto refusal = refuse_without_accounts(services)) return *std::move(refusal);
  const Json json = parse_json(request.body);
  const bool fits = json.is_object() && json.contains("app") && json["app"].is_string();
  if (!fits) return error_response(400, R"(the body is {"app": NAME})");
  const auto app = AccountName::from(json["app"].get<std::string>());
  if (!app) return error_response(app.error().within("app"));
  const auto token = services.desk.apps.ask(*app, request.peer, now());
  if (!token) return error_response(429, "too many programs ask for a key; try again later");
  services.events.publish("apps", Json{{"app", app->text()}}.dump());
  const std::string site = "http://" + request.header("host");
  HttpResponse response = json_response({{"app_token", *token}, {"auth_dialog", site + "/"}}, 201);
  response.headers.emplace_back("Location", site + "/plugin/appkeys/request/" + *token);
  return response;
}

HttpResponse octo_appkeys_answer(const HttpRequest& request, Services& services) {
  const auto key = services.desk.apps.answer(request.parameter("token"), now());
  if (!key) return error_response(404, "refused, or nobody decided in time");
  if (key->empty()) return json_response({{"message", "Awaiting decision"}}, 202);
  return json_response({{"api_key", *key}});
}

HttpResponse get_app_requests(const HttpRequest&, Services& services) {
  Json list = Json::array();
  for (const auto& each : services.desk.apps.waiting(now())) {
    list.push_back({{"id", each.id}, {"app", each.app}, {"from", each.from}});
  }
  return json_response({{"requests", list}});
}

HttpResponse post_app_request(const HttpRequest& request, Services& services) {
  Texts texts = texts_of(request, {"scope", "password"});
  if (texts.refusal) return std::move(*texts.refusal);
  const auto scope = scope_named(texts.values["scope"]);
  if (!scope) return error_response(400, "scope: must be read, print, control or admin");
  const auto id = id_in(request);
  const auto app = id ? services.desk.apps.name_of(*id, now()) : std::nullopt;
  if (!app) return no_such_request();
  Confirmed confirmed = confirm_password(request, texts.values["password"], services);
  if (confirmed.refusal) return std::move(*confirmed.refusal);
  const auto made = services.accounts.add_key(confirmed.user.id, *AccountName::from(*app), *scope,
                                              std::int64_t{std::time(nullptr)});
  if (!made) return error_response(made.error());
  services.desk.apps.give(*id, made->token);
  return empty_response();
}

HttpResponse delete_app_request(const HttpRequest& request, Services& services) {
  const auto id = id_in(request);
  return id && services.desk.apps.refuse(*id) ? empty_response() : no_such_request();
}

}  // namespace slipstick
