#include "host/file_lines.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace slipstick {
namespace {

constexpr std::size_t kBlock = 65'536;

}  // namespace

Result<std::unique_ptr<FileLines>> FileLines::open(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return fail(ErrorCode::kInput, fmt::format("cannot read {}: {}", path.string(),
                                               std::generic_category().message(errno)));
  }
  return std::unique_ptr<FileLines>(new FileLines(path, std::move(stream)));
}

Result<std::int64_t> FileLines::check(const std::filesystem::path& path) {
  const auto lines = open(path);
  if (!lines) return fail(lines.error());
  for (std::int64_t count = 0;; ++count) {
    const auto line = (*lines)->next();
    if (!line) return fail(line.error());
    if (!*line) return count;
  }
}

Result<std::optional<Line>> FileLines::next() {
  while (true) {
    if (auto line = pace_.pop(); line || ended_) return line;
    auto command = next_command();
    if (!command) return command;
    ended_ = !*command;
    if (ended_) {
      pace_.end();
    } else {
      pace_.push(**std::move(command));
    }
  }
}

Result<std::optional<Line>> FileLines::next_command() {
  while (read_line()) {
    ++number_;
    if (text_.size() > kMaxLine) {
      return fail(ErrorCode::kInput,
                  fmt::format("{}: a line of more than {} bytes; is it G-code?", here(), kMaxLine));
    }
    auto line = normalise(text_);
    if (!line) return fail(line.error().within(here()));
    if (*line) return line;
  }
  if (stream_.bad()) {
    return fail(ErrorCode::kUnavailable, fmt::format("cannot read {} any further", here()));
  }
  return std::optional<Line>();
}

std::string FileLines::here() const {
  return fmt::format("{}:{}", path_.string(), number_);
}

bool FileLines::fill() {
  block_.resize(kBlock);
  stream_.read(block_.data(), static_cast<std::streamsize>(kBlock));
  block_.resize(static_cast<std::size_t>(stream_.gcount()));
  at_ = 0;
  return !block_.empty();
}

bool FileLines::read_line() {
  text_.clear();
  while (text_.size() <= kMaxLine) {
    // What was read of a line when reading failed is not the line.
    if (at_ == block_.size() && !fill()) return !text_.empty() && !stream_.bad();
    const char byte = block_[at_++];
    const bool second_half = std::exchange(after_return_, byte == '\r') && byte == '\n';
    if (second_half) continue;
    if (byte == '\n' || byte == '\r') return true;
    text_ += byte;
  }
  return true;
}

}  // namespace slipstick
