#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "drivers/unique_fd.h"

namespace slipstick::test {

struct HttpReply {
  int status = 0;                              ///< 0: the connection ended without one.
  std::map<std::string, std::string> headers;  ///< Names in lower case.
  std::string body;
};

/// A connection to 127.0.0.1 that sends just the bytes it is given: what real clients send is
/// replayed by it, and what none should send, too. Independent of the server's library. Waits at
/// most 60 seconds for anything.
class HttpClient {
 public:
  explicit HttpClient(std::uint16_t port);

  void send(std::string_view bytes);
  /// The next reply, with its body by Content-Length or up to the end.
  [[nodiscard]] HttpReply reply();
  /// Up to and including `end`, or what there is when the connection ends.
  [[nodiscard]] std::string read_until(std::string_view end);
  /// So many bytes, or what there is when the connection ends.
  [[nodiscard]] std::string read(std::size_t size);
  [[nodiscard]] bool ended();
  /// Whether it ends, or is reset, within so long; what comes instead is kept.
  [[nodiscard]] bool ended_within(std::chrono::milliseconds patience);
  /// No more bytes are sent; replies may still come.
  void end_sending();

 private:
  bool fill();

  UniqueFd socket_;
  std::string pending_;
};

/// One request on a connection of its own. `head` has further header lines, each ended by "\r\n".
[[nodiscard]] HttpReply request(std::uint16_t port, std::string_view method,
                                std::string_view target, std::string_view body = "",
                                std::string_view head = "");

}  // namespace slipstick::test
