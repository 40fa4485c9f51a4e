#include "host/serve/access.h"

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

}  // namespace

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  int difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= a[i] ^ b[i];
  return difference == 0;
}

std::optional<HttpResponse> AccessRules::check(const HttpRequest& request) const {
  const std::string& host = request.header("host");
  const std::string& origin = request.header("origin");
  // A page of another site, or a name of another site that was made to point here.
  if (!origin.empty() && host_of_origin(origin) != host) {
    return error_response(403, "requests from pages of other sites are not answered");
  }
  if (key_.empty()) {
    if (is_local(without_port(host))) return {};
    return error_response(403, "without a key only requests to localhost are answered");
  }
  if (key_shown(request)) return {};
  return error_response(403, "show the key in the header X-Api-Key");
}

bool AccessRules::key_shown(const HttpRequest& request) const {
  if (equal_in_constant_time(request.header("x-api-key"), key_)) return true;
  constexpr std::string_view kBearer = "Bearer ";
  const std::string& authorization = request.header("authorization");
  return authorization.starts_with(kBearer) &&
         equal_in_constant_time(std::string_view(authorization).substr(kBearer.size()), key_);
}

}  // namespace slipstick
