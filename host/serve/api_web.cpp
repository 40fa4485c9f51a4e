// The page, for browsers.
#include <algorithm>

#include "host/serve/api.h"
#include "host/serve/web_assets.h"

namespace slipstick {
namespace {

// Nothing is loaded from elsewhere, and no text becomes a script.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
    "img-src 'self' data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string type_of(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  return "text/javascript; charset=utf-8";
}

HttpResponse asset(std::string_view name) {
  const auto assets = web_assets();
  const auto at = std::find_if(assets.begin(), assets.end(),
                               [&](const WebAsset& each) { return each.name == name; });
  if (at == assets.end()) return error_response(404, "there is nothing here");
  return {200, type_of(name), std::string(at->text), {{"Content-Security-Policy", kPolicy}}};
}

}  // namespace

HttpResponse get_page(const HttpRequest&, Services&) {
  return asset("index.html");
}

HttpResponse get_asset(const HttpRequest& request, Services&) {
  return asset(request.parameter("name"));
}

}  // namespace slipstick
