#pragma once

#include <cstdint>
#include <string>

#include "drivers/unique_fd.h"

namespace slipstick::test {

/// A web server on 127.0.0.1 that takes one request at a time, when the test asks for it.
class WebListener {
 public:
  WebListener();

  [[nodiscard]] std::string url() const;
  /// The next request, head and body, answered by `reply` ("204 No Content"); empty if none comes
  /// within a minute.
  [[nodiscard]] std::string request(const std::string& reply);

 private:
  UniqueFd socket_;
  std::uint16_t port_ = 0;
};

}  // namespace slipstick::test
