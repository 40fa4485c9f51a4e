#include "drivers/transport_address.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <utility>

namespace slipstick {
namespace {

constexpr std::size_t kMaxAddress = 1024;
constexpr int kDefaultBaud = 115'200;
constexpr int kMinBaud = 1200;
constexpr int kMaxBaud = 4'000'000;

tl::unexpected<Error> wrong(std::string_view text, std::string_view why) {
  return fail(ErrorCode::kInput, fmt::format("port '{}': {}", text, why));
}

template <typename Integer>
std::optional<Integer> whole_number(std::string_view text, int base) {
  Integer value{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value, base);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return value;
}

/// Takes the text up to `separator` (or all of it) off the front of `text`, and the separator.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t at = text.find(separator);
  const std::string_view head = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return head;
}

Result<TransportAddress> with_options(TransportAddress address, std::string_view options) {
  while (!options.empty()) {
    std::string_view value = take_until(options, '&');
    const std::string_view pair = value;
    const std::string_view key = take_until(value, '=');
    if (key.empty() || key.size() == pair.size()) {
      return wrong(pair, "an option is written key=value");
    }
    if (!address.options.emplace(key, value).second) {
      return wrong(pair, "this option is given twice");
    }
  }
  return address;
}

Result<TransportAddress> parse_tcp(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  const auto port = colon == std::string_view::npos
                        ? std::nullopt
                        : whole_number<std::uint16_t>(text.substr(colon + 1), 10);
  if (!port || *port == 0 || colon == 0) {
    return wrong(text, "a network printer is written tcp:HOST:PORT, as tcp:localhost:2323");
  }
  std::string_view host = text.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
  }
  return TransportAddress{
      .kind = TransportKind::kTcp, .target = std::string(host), .port = *port, .options = {}};
}

Result<TransportAddress> parse_usb(std::string_view text) {
  std::string_view rest = text;
  const auto vendor = whole_number<std::uint16_t>(take_until(rest, ':'), 16);
  const auto product = whole_number<std::uint16_t>(take_until(rest, ':'), 16);
  if (!vendor || !product) {
    return wrong(text,
                 "a USB adapter is written usb:VID:PID[:SERIAL] in hexadecimal, as "
                 "usb:1a86:7523");
  }
  return TransportAddress{.kind = TransportKind::kUsb,
                          .target = std::string(rest),
                          .vendor_id = *vendor,
                          .product_id = *product,
                          .options = {}};
}

Result<TransportAddress> parse_path(TransportKind kind, std::string_view text) {
  if (text.empty() || text.find('\0') != std::string_view::npos) {
    return wrong(text, "the path is missing, as in pty:/tmp/printer");
  }
  return TransportAddress{.kind = kind, .target = std::string(text), .options = {}};
}

Result<TransportAddress> parse_place(std::string_view text) {
  const auto after = [&](std::string_view scheme) { return text.substr(scheme.size()); };
  if (text.starts_with("usb:")) return parse_usb(after("usb:"));
  if (text.starts_with("tcp:")) return parse_tcp(after("tcp:"));
  if (text.starts_with("pty:")) return parse_path(TransportKind::kPty, after("pty:"));
  if (text == "sim:") {
    return TransportAddress{.kind = TransportKind::kSim, .target = {}, .options = {}};
  }
  if (text.starts_with('/')) return parse_path(TransportKind::kSerial, text);
  return wrong(text, "not one of /dev/NAME, usb:VID:PID, pty:PATH, tcp:HOST:PORT, sim:");
}

bool takes_baud(TransportKind kind) {
  return kind == TransportKind::kSerial || kind == TransportKind::kUsb;
}

}  // namespace

Result<TransportAddress> parse_transport_address(std::string_view text) {
  if (text.size() > kMaxAddress) return wrong(text.substr(0, 40), "this is too long");
  std::string_view options = text;
  const std::string_view place = take_until(options, '?');
  auto address = parse_place(place);
  if (!address) return address;
  address = with_options(*std::move(address), options);
  if (!address || address->kind == TransportKind::kSim) return address;
  for (const auto& [key, value] : address->options) {
    if (key != "baud" || !takes_baud(address->kind)) {
      return wrong(text, fmt::format("there is no option '{}' for this kind of port", key));
    }
  }
  if (auto baud = baud_rate(*address); !baud) return fail(baud.error());
  return address;
}

Result<int> baud_rate(const TransportAddress& address) {
  const auto option = address.options.find("baud");
  if (option == address.options.end()) return kDefaultBaud;
  const auto baud = whole_number<int>(option->second, 10);
  if (!baud || *baud < kMinBaud || *baud > kMaxBaud) {
    return wrong(
        "baud=" + option->second,
        fmt::format("a baud rate is from {} to {}, usually 115200 or 250000", kMinBaud, kMaxBaud));
  }
  return *baud;
}

}  // namespace slipstick
