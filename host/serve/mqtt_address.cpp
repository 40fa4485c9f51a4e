#include "host/serve/mqtt_address.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace slipstick {
namespace {

constexpr std::uint16_t kPlainPort = 1883;
constexpr std::uint16_t kTlsPort = 8883;
constexpr std::size_t kNameMax = 64;

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_';
}

tl::unexpected<Error> not_an_address(std::string_view text) {
  return fail(ErrorCode::kInput,
              fmt::format("--mqtt wants mqtt://[USER@]HOST[:PORT] or mqtts://…, not '{}'", text));
}

}  // namespace

Result<MqttAddress> parse_mqtt_address(std::string_view text) {
  MqttAddress address;
  std::string_view rest = text;
  address.tls = rest.starts_with("mqtts://");
  if (!address.tls && !rest.starts_with("mqtt://")) return not_an_address(text);
  rest.remove_prefix(rest.find("//") + 2);
  address.port = address.tls ? kTlsPort : kPlainPort;
  if (const std::size_t at = rest.rfind('@'); at != rest.npos) {
    address.user = rest.substr(0, at);
    rest.remove_prefix(at + 1);
    if (address.user.empty()) return not_an_address(text);
    if (address.user.find(':') != std::string::npos) {
      return fail(ErrorCode::kInput, "--mqtt takes no password; --mqtt-password-file does");
    }
  }
  if (const std::size_t colon = rest.rfind(':'); colon != rest.npos) {
    const std::string_view digits = rest.substr(colon + 1);
    const char* const end = digits.data() + digits.size();
    const auto [last, error] = std::from_chars(digits.data(), end, address.port);
    if (error != std::errc() || last != end || address.port == 0) return not_an_address(text);
    rest = rest.substr(0, colon);
  }
  address.host = rest;
  const bool odd =
      std::any_of(rest.begin(), rest.end(), [](char c) { return !is_of_name(c) && c != '.'; });
  if (rest.empty() || odd) return not_an_address(text);
  return address;
}

Result<std::string> parse_mqtt_name(std::string_view text) {
  if (!text.empty() && text.size() <= kNameMax && std::all_of(text.begin(), text.end(), is_of_name))
    return std::string(text);
  return fail(ErrorCode::kInput,
              fmt::format("--mqtt-name wants 1 to {} letters, digits, '-' and '_', not '{}'",
                          kNameMax, text));
}

std::string default_mqtt_name() {
  std::array<char, kNameMax + 1> host{};
  if (::gethostname(host.data(), kNameMax) != 0 || host[0] == '\0') return "slipstick";
  std::string name = host.data();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_of_name(c); }, '_');
  return name;
}

}  // namespace slipstick
