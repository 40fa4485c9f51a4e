#include "sim/line_reader.h"

namespace slipstick {

namespace {

constexpr char kBackspace = '\b';

}  // namespace

void LineReader::reset() {
  line_.clear();
  state_ = State::kNormal;
  done_ = false;
}

void LineReader::add(char byte) {
  if (byte == kBackspace) {
    if (!line_.empty()) line_.pop_back();
    return;
  }
  line_ += byte;
  if (line_.size() >= length_max_) state_ = State::kSkipping;
}

std::optional<std::string_view> LineReader::feed(char byte) {
  if (done_) reset();
  if (byte == '\n' || byte == '\r') {
    state_ = State::kNormal;
    if (line_.empty()) return std::nullopt;
    done_ = true;
    return std::string_view(line_).substr(0, line_.find('\0'));
  }
  if (state_ == State::kSkipping) return std::nullopt;
  if (state_ == State::kEscaped) {
    state_ = State::kNormal;
    add(byte);
  } else if (byte == '\\') {
    state_ = State::kEscaped;
  } else if (byte == ';') {
    state_ = State::kSkipping;
  } else {
    add(byte);
  }
  return std::nullopt;
}

}  // namespace slipstick
