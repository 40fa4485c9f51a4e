#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "host/serve/caller.h"

namespace slipstick {

/// \file
/// Requests and responses as plain values, without sockets: what routes are written in.

enum class HttpMethod : std::uint8_t { kGet, kPost, kPut, kDelete, kOther };

/// A request target taken apart. Everything is percent-decoded, segment by segment: a `/` inside a
/// segment was written `%2F` and separates nothing.
struct HttpTarget {
  static constexpr std::size_t kSizeMax = 4096;
  static constexpr std::size_t kSegmentsMax = 16;
  static constexpr std::size_t kQueryMax = 64;

  std::vector<std::string> path;
  std::map<std::string, std::string> query;
};

/// \return nothing for a target that is too long, does not begin with `/`, or has a broken escape.
[[nodiscard]] std::optional<HttpTarget> parse_http_target(std::string_view text);

/// One segment of a path, with everything escaped that is not a letter, a digit or one of `-._~`.
[[nodiscard]] std::string percent_encoded(std::string_view segment);

/// A body that was received into a file, which is the receiver's to move or to leave.
struct HttpUpload {
  std::string path;  ///< Where the bytes are: chosen by the server, never by the client.
  std::string name;  ///< What the client calls it; not checked.
  std::map<std::string, std::string> fields;  ///< The other parts of a form.
  std::uint64_t size = 0;
};

struct HttpRequest {
  HttpMethod method = HttpMethod::kGet;
  HttpTarget target;
  std::map<std::string, std::string> headers;     ///< Names in lower case.
  std::map<std::string, std::string> parameters;  ///< From the pattern of the route.
  std::string body;
  std::optional<HttpUpload> upload;
  std::string peer;  ///< Where it comes from, as `http_peer` counts it.
  Caller caller;     ///< Who asks: of `AccessRules`.

  /// The value, or an empty text.
  [[nodiscard]] const std::string& header(const std::string& name) const;
  [[nodiscard]] const std::string& parameter(const std::string& name) const;
};

struct HttpResponse {
  unsigned status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
};

/// The document in `text`; discarded if there is none, or one that is nested more deeply (32) or
/// has more members and values (about 4,000) than any that is asked for: copying and writing it
/// would recurse, and members are looked for one by one.
[[nodiscard]] nlohmann::ordered_json parse_json(std::string_view text);

/// 200 with a document, or `status`.
[[nodiscard]] HttpResponse json_response(const nlohmann::ordered_json& json, unsigned status = 200);
/// 204.
[[nodiscard]] HttpResponse empty_response();
/// `{"error": message}`.
[[nodiscard]] HttpResponse error_response(unsigned status, std::string_view message);
/// The same with the status that suits the code: 400, 503, …
[[nodiscard]] HttpResponse error_response(const Error& error);

}  // namespace slipstick
