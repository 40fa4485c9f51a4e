#include "host/serve/http.h"

#include <nlohmann/json.hpp>

namespace slipstick {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

enum class Plus { kItself, kBlank };

std::optional<std::string> percent_decoded(std::string_view text, Plus plus) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%') {
      if (i + 2 >= text.size()) return {};
      const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
      if (high < 0 || low < 0) return {};
      out += static_cast<char>(high * 16 + low);
      i += 2;
    } else {
      out += text[i] == '+' && plus == Plus::kBlank ? ' ' : text[i];
    }
  }
  return out;
}

// Calls `part` for each piece of `text` between separators; false as soon as it says so.
template <typename Part>
bool each_piece(std::string_view text, char separator, Part part) {
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (!part(text.substr(0, end))) return false;
    if (end == text.size()) return true;
    text.remove_prefix(end + 1);
  }
}

bool add_segment(HttpTarget& target, std::string_view text) {
  auto segment = percent_decoded(text, Plus::kItself);
  if (!segment || target.path.size() == HttpTarget::kSegmentsMax) return false;
  target.path.push_back(std::move(*segment));
  return true;
}

bool add_query(HttpTarget& target, std::string_view text) {
  if (text.empty()) return true;
  const std::size_t equals = std::min(text.find('='), text.size());
  auto key = percent_decoded(text.substr(0, equals), Plus::kBlank);
  auto value = percent_decoded(equals == text.size() ? "" : text.substr(equals + 1), Plus::kBlank);
  if (!key || !value || target.query.size() == HttpTarget::kQueryMax) return false;
  target.query.emplace(std::move(*key), std::move(*value));
  return true;
}

const std::string& value_or_empty(const std::map<std::string, std::string>& map,
                                  const std::string& key) {
  static const std::string kEmpty;
  const auto at = map.find(key);
  return at == map.end() ? kEmpty : at->second;
}

unsigned status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInput:
      return 400;
    case ErrorCode::kPrinter:
    case ErrorCode::kCancelled:
      return 409;
    case ErrorCode::kUnavailable:
    case ErrorCode::kTimedOut:
    case ErrorCode::kDisconnected:
      break;
  }
  return 503;
}

}  // namespace

std::optional<HttpTarget> parse_http_target(std::string_view text) {
  if (text.size() > HttpTarget::kSizeMax || text.empty() || text[0] != '/') return {};
  HttpTarget target;
  const std::size_t question = std::min(text.find('?'), text.size());
  const bool good = each_piece(text.substr(1, question - 1), '/',
                               [&](std::string_view piece) { return add_segment(target, piece); });
  if (!good) return {};
  if (question == text.size()) return target;
  const bool asked = each_piece(text.substr(question + 1), '&',
                                [&](std::string_view piece) { return add_query(target, piece); });
  return asked ? std::optional(std::move(target)) : std::nullopt;
}

std::string percent_encoded(std::string_view segment) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string out;
  for (const char c : segment) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~").find(c) != std::string_view::npos;
    const auto byte = static_cast<unsigned char>(c);
    if (plain) {
      out += c;
    } else {
      out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return out;
}

const std::string& HttpRequest::header(const std::string& name) const {
  return value_or_empty(headers, name);
}

const std::string& HttpRequest::parameter(const std::string& name) const {
  return value_or_empty(parameters, name);
}

nlohmann::ordered_json parse_json(std::string_view text) {
  using Json = nlohmann::ordered_json;
  constexpr int kDepthMax = 32;
  constexpr int kEventsMax = 8'192;  // of the parser: an object of n members is built in n² steps
  int events = 0;
  bool too_much = false;
  const auto keep = [&](int depth, Json::parse_event_t, Json&) {
    too_much |= depth > kDepthMax || ++events > kEventsMax;
    return !too_much;
  };
  Json json = Json::parse(text, keep, false);
  return too_much ? Json(Json::value_t::discarded) : json;
}

HttpResponse json_response(const nlohmann::ordered_json& json, unsigned status) {
  // Texts of printers and files are not always UTF-8.
  return {status, "application/json",
          json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"};
}

HttpResponse empty_response() {
  return {204, "", ""};
}

HttpResponse error_response(unsigned status, std::string_view message) {
  return json_response({{"error", message}}, status);
}

HttpResponse error_response(const Error& error) {
  return error_response(status_of(error.code), error.message);
}

}  // namespace slipstick
