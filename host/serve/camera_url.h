#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace slipstick {

/// Where pictures of the printer come from: `http://HOST[:PORT]/PATH` or the same with https.
/// Browsers fetch them from there; the daemon itself never does.
class CameraUrl {
 public:
  static constexpr std::size_t kSizeMax = 1000;

  /// \return kInput for another scheme, no host, a name or password in it (browsers send none for a
  /// picture, and all who see the page would see them), or bytes that no address has.
  [[nodiscard]] static Result<CameraUrl> from(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// "http://camera.local:8080": a source as a Content-Security-Policy names it.
  [[nodiscard]] std::string_view origin() const {
    return std::string_view(text_).substr(0, origin_);
  }

 private:
  CameraUrl(std::string_view text, std::size_t origin) : text_(text), origin_(origin) {}

  std::string text_;
  std::size_t origin_;  // its length
};

}  // namespace slipstick
