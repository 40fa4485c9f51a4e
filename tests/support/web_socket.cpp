#include "tests/support/web_socket.h"

#include "core/base/check.h"

namespace slipstick::test {
namespace {

// The key and the answer to it that RFC 6455 gives as an example.
constexpr std::string_view kKey = "dGhlIHNhbXBsZSBub25jZQ==";
constexpr std::string_view kAnswer = "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=";
constexpr std::string_view kMask = "\x12\x34\x56\x78";

unsigned byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

// Bytes of the length behind the second byte.
std::size_t length_bytes(unsigned second) {
  const unsigned length = second & 0x7f;
  return length == 126 ? 2 : length == 127 ? 8 : 0;
}

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value = value << 8 | byte_at(bytes, i);
  return value;
}

std::uint64_t payload_size(std::string_view head) {
  const std::size_t more = length_bytes(byte_at(head, 1));
  return more == 0 ? byte_at(head, 1) & 0x7f : big_endian(head.substr(2, more));
}

}  // namespace

std::string frame_bytes(int first, std::string_view payload) {
  std::string bytes(1, static_cast<char>(first));
  const std::size_t size = payload.size();
  if (size < 126) {
    bytes += static_cast<char>(0x80 | size);
  } else {
    const bool is_long = size > 0xffff;
    bytes += static_cast<char>(0x80 | (is_long ? 127 : 126));
    for (int shift = is_long ? 56 : 8; shift >= 0; shift -= 8) {
      bytes += static_cast<char>(std::uint64_t{size} >> shift);
    }
  }
  bytes += kMask;
  for (std::size_t i = 0; i < size; ++i) {
    bytes += static_cast<char>(payload[i] ^ kMask[i % kMask.size()]);
  }
  return bytes;
}

std::optional<WebSocketFrame> take_frame(std::string& bytes) {
  if (bytes.size() < 2) return {};
  const std::size_t head = 2 + length_bytes(byte_at(bytes, 1));
  if (bytes.size() < head) return {};
  const std::uint64_t size = payload_size(bytes);
  if (bytes.size() - head < size) return {};
  WebSocketFrame frame{static_cast<int>(byte_at(bytes, 0)), byte_at(bytes, 1) >= 0x80,
                       bytes.substr(head, size)};
  bytes.erase(0, head + size);
  return frame;
}

WebSocketClient::WebSocketClient(std::uint16_t port, std::string_view target, std::string_view head)
    : http_(port) {
  std::string request("GET ");
  request.append(target).append(" HTTP/1.1\r\nHost: localhost\r\n").append(head);
  request.append("Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n");
  request.append("Sec-WebSocket-Key: ").append(kKey).append("\r\n\r\n");
  http_.send(request);
  const std::string answer = http_.read_until("\r\n\r\n");
  if (answer.starts_with("HTTP/1.1 101 ")) {
    open_ = answer.find(kAnswer) != answer.npos;
    return;
  }
  if (answer.size() > 12) refusal_.status = std::stoi(answer.substr(9, 3));
}

std::optional<WebSocketFrame> WebSocketClient::frame() {
  std::string bytes = http_.read(2);
  if (bytes.size() < 2) return {};
  bytes += http_.read(length_bytes(byte_at(bytes, 1)));
  bytes += http_.read(payload_size(bytes));
  auto frame = take_frame(bytes);
  if (frame) SLIPSTICK_CHECK(!frame->masked);  // what servers send never is
  return frame;
}

std::optional<std::string> WebSocketClient::text() {
  while (auto next = frame()) {
    if (next->opcode() == kTextFrame) return std::move(next->payload);
    if (next->opcode() == kCloseFrame) return {};
    if (next->opcode() == kPingFrame) send(frame_bytes(kFinalFrame | kPongFrame, next->payload));
  }
  return {};
}

std::optional<int> WebSocketClient::close_code() {
  while (const auto next = frame()) {
    if (next->opcode() != kCloseFrame) continue;
    return static_cast<int>(big_endian(std::string_view(next->payload).substr(0, 2)));
  }
  return {};
}

}  // namespace slipstick::test
