#pragma once

#include <optional>
#include <string>

#include "host/serve/http.h"

namespace slipstick {

/// Who may ask. On the loopback address everybody on the machine may, but no web page of another
/// site (the browser would send its requests from here); on any other address only who shows the
/// key.
class AccessRules {
 public:
  /// \param key empty: none is needed, and only requests to this machine's own names are answered.
  explicit AccessRules(std::string key) : key_(std::move(key)) {}

  /// The refusal (403), or nothing.
  [[nodiscard]] std::optional<HttpResponse> check(const HttpRequest& request) const;

 private:
  [[nodiscard]] bool key_shown(const HttpRequest& request) const;

  const std::string key_;
};

/// The same time for all texts of one size, whatever they differ in.
[[nodiscard]] bool equal_in_constant_time(std::string_view a, std::string_view b);

}  // namespace slipstick
