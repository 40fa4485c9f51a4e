// /api/v1/keys: what programs show in place of a password.
#include <ctime>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/passwords.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Accounts::Key& key) {
  return {{"id", key.id},
          {"name", key.name},
          {"scope", name_of(key.scope)},
          {"created", key.created},
          {"used", key.used == 0 ? Json() : Json(key.used)}};
}

}  // namespace

HttpResponse get_keys(const HttpRequest&, Services& services) {
  const auto keys = services.accounts.keys();
  if (!keys) return error_response(keys.error());
  Json list = Json::array();
  for (const Accounts::Key& key : *keys) list.push_back(to_json(key));
  return json_response({{"keys", list}});
}

HttpResponse post_key(const HttpRequest& request, Services& services) {
  Texts texts = texts_of(request, {"name", "scope", "password"});
  if (texts.refusal) return std::move(*texts.refusal);
  const auto name = AccountName::from(texts.values["name"]);
  if (!name) return error_response(name.error());
  const auto scope = scope_named(texts.values["scope"]);
  if (!scope) return error_response(400, "scope: must be read, print, control or admin");
  Confirmed confirmed = confirm_password(request, texts.values["password"], services);
  if (confirmed.refusal) return std::move(*confirmed.refusal);
  const auto made =
      services.accounts.add_key(confirmed.user.id, *name, *scope, std::int64_t{std::time(nullptr)});
  if (!made) return error_response(made.error());
  Json json = to_json(made->key);
  json["key"] = made->token;
  return json_response(json, 201);
}

HttpResponse delete_key(const HttpRequest& request, Services& services) {
  const auto id = id_in(request);
  if (!id) return error_response(404, "there is no such key");
  const auto removed = services.accounts.remove_key(*id);
  if (!removed) return error_response(removed.error());
  return *removed ? empty_response() : error_response(404, "there is no such key");
}

}  // namespace slipstick
