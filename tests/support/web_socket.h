#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tests/support/http_client.h"

namespace slipstick::test {

/// One frame of RFC 6455 as it came.
struct WebSocketFrame {
  int first = 0;  ///< FIN, reserved bits and opcode.
  bool masked = false;
  std::string payload;
  [[nodiscard]] int opcode() const { return first & 0x0f; }
};

inline constexpr int kContinuationFrame = 0, kTextFrame = 1, kCloseFrame = 8, kPingFrame = 9,
                     kPongFrame = 10, kFinalFrame = 0x80;

/// The bytes of a frame as a client sends it, masked. \param first FIN, reserved bits and opcode.
[[nodiscard]] std::string frame_bytes(int first, std::string_view payload);
/// The first whole frame in `bytes`, which is taken off.
[[nodiscard]] std::optional<WebSocketFrame> take_frame(std::string& bytes);

/// A WebSocket to 127.0.0.1 with framing of its own. Waits at most 60 seconds for anything.
class WebSocketClient {
 public:
  /// \param head further header lines, each ended by "\r\n".
  WebSocketClient(std::uint16_t port, std::string_view target, std::string_view head = "");

  /// Whether the server agreed, in the way of the protocol; else `refusal` is its answer.
  [[nodiscard]] bool is_open() const { return open_; }
  [[nodiscard]] const HttpReply& refusal() const { return refusal_; }

  void say(std::string_view text) { send(frame_bytes(kFinalFrame | kTextFrame, text)); }
  /// Any bytes.
  void send(std::string_view bytes) { http_.send(bytes); }
  /// The next frame, nothing at the end of the connection.
  [[nodiscard]] std::optional<WebSocketFrame> frame();
  /// The next text; pings are answered. Nothing at the end, or after a close frame.
  [[nodiscard]] std::optional<std::string> text();
  /// What stands in the close frame, if one comes before the end; texts before are skipped.
  [[nodiscard]] std::optional<int> close_code();

 private:
  HttpClient http_;
  HttpReply refusal_;
  bool open_ = false;
};

}  // namespace slipstick::test
