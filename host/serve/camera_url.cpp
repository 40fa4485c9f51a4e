#include "host/serve/camera_url.h"

#include <fmt/format.h>

#include <algorithm>

namespace slipstick {
namespace {

// Printable ASCII but what ends an address in a header or in a page.
bool may_stand(char c) {
  return c > ' ' && c <= '~' &&
         std::string_view("\"'<>\\^`{|};,").find(c) == std::string_view::npos;
}

bool is_of_host(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || (c >= '0' && c <= '9') ||
         std::string_view(".-:[]").find(c) != std::string_view::npos;
}

}  // namespace

Result<CameraUrl> CameraUrl::from(std::string_view text) {
  const auto wrong = [&](std::string_view why) {
    return fail(
        ErrorCode::kInput,
        fmt::format("camera: {}; give an address such as http://camera.local:8080/stream", why));
  };
  if (text.size() > kSizeMax) return wrong("the address is too long");
  const std::size_t scheme = text.starts_with("http://") ? 7 : text.starts_with("https://") ? 8 : 0;
  if (scheme == 0) return wrong("only http:// and https:// are shown");
  if (!std::all_of(text.begin(), text.end(), may_stand))
    return wrong("a character that no address has");
  const std::size_t end = std::min(text.find_first_of("/?#", scheme), text.size());
  const std::string_view host = text.substr(scheme, end - scheme);
  if (host.find('@') != host.npos)
    return wrong("a name or password in it would be shown to everybody");
  if (host.empty() || !std::all_of(host.begin(), host.end(), is_of_host)) return wrong("no host");
  return CameraUrl(text, end);
}

}  // namespace slipstick
