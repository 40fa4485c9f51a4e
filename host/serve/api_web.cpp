// The page, for browsers.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/serve/api.h"
#include "host/serve/web_assets.h"

namespace slipstick {
namespace {

// Nothing is loaded from elsewhere, and no text becomes a script.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'; img-src 'self' data:";

// With the camera's pictures, where there is one.
std::string policy(const Services& services) {
  if (!services.camera) return kPolicy;
  return fmt::format("{} {}", kPolicy, services.camera->origin());
}

std::string type_of(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  return "text/javascript; charset=utf-8";
}

HttpResponse asset(std::string_view name, const Services& services) {
  const auto assets = web_assets();
  const auto at = std::find_if(assets.begin(), assets.end(),
                               [&](const WebAsset& each) { return each.name == name; });
  if (at == assets.end()) return error_response(404, "there is nothing here");
  return {
      200, type_of(name), std::string(at->text), {{"Content-Security-Policy", policy(services)}}};
}

}  // namespace

HttpResponse get_page(const HttpRequest&, Services& services) {
  return asset("index.html", services);
}

HttpResponse get_login_page(const HttpRequest&, Services& services) {
  return asset("login.html", services);
}

HttpResponse get_setup_page(const HttpRequest&, Services& services) {
  return asset("setup.html", services);
}

HttpResponse get_asset(const HttpRequest& request, Services& services) {
  return asset(request.parameter("name"), services);
}

HttpResponse get_camera(const HttpRequest&, Services& services) {
  nlohmann::ordered_json url;
  if (services.camera) url = services.camera->text();
  return json_response({{"url", url}});
}

}  // namespace slipstick
