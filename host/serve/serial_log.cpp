#include "host/serve/serial_log.h"

#include <fmt/format.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <fstream>

namespace slipstick {
namespace {

constexpr std::size_t kOldFiles = 1;
constexpr std::size_t kLineMost = 256;  // bytes; longer ones are told in pieces

// What cannot be read is told by its number: noise must be seen, and cannot command a terminal.
void append(std::string& line, char c) {
  if (c >= ' ' && c <= '~') {
    line += c;
  } else if (c != '\r') {
    line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
}

}  // namespace

Result<void> SerialLog::start() {
  if (is_on()) return {};
  try {
    auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(file().string(), kFileMost,
                                                                       kOldFiles);
    auto logger = std::make_shared<spdlog::logger>("serial", std::move(sink));
    logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %v");
    logger->flush_on(spdlog::level::info);
    const std::lock_guard lock(mutex_);
    lines_ = std::move(logger);
    return {};
  } catch (const spdlog::spdlog_ex& error) {
    return fail(ErrorCode::kUnavailable, error.what());
  }
}

void SerialLog::stop() {
  const std::lock_guard lock(mutex_);
  lines_.reset();
}

bool SerialLog::is_on() const {
  return lines() != nullptr;
}

std::shared_ptr<spdlog::logger> SerialLog::lines() const {
  const std::lock_guard lock(mutex_);
  return lines_;
}

Result<std::string> SerialLog::tail() const {
  std::error_code none;
  if (!std::filesystem::exists(file(), none)) return std::string();
  std::ifstream bytes(file(), std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(bytes.tellg(), 0));
  const std::size_t wanted = std::min(size, kTailMost);
  std::string text(wanted, '\0');
  bytes.seekg(static_cast<std::streamoff>(size - wanted));
  bytes.read(text.data(), static_cast<std::streamsize>(wanted));
  if (!bytes) return fail(ErrorCode::kUnavailable, "cannot read " + file().string());
  if (wanted < size) text.erase(0, text.find('\n') + 1);
  return text;
}

void SerialLog::add(char direction, std::string& begun, std::string_view bytes) {
  const auto log = lines();
  if (!log) return begun.clear();
  for (const char c : bytes) {
    if (c != '\n') append(begun, c);
    if (c != '\n' && begun.size() < kLineMost) continue;
    log->info("{} {}", direction, begun);
    begun.clear();
  }
}

Result<std::size_t> LoggedTransport::read_some(std::span<char> buffer,
                                               std::chrono::microseconds patience) {
  auto got = printer_->read_some(buffer, patience);
  if (got) log_.received({buffer.data(), *got});
  return got;
}

Result<std::size_t> LoggedTransport::write_some(std::string_view bytes,
                                                std::chrono::microseconds patience) {
  auto took = printer_->write_some(bytes, patience);
  if (took) log_.sent(bytes.substr(0, *took));
  return took;
}

Result<void> LoggedTransport::write_all(std::string_view bytes,
                                        std::chrono::microseconds patience) {
  auto done = printer_->write_all(bytes, patience);
  if (done) log_.sent(bytes);
  return done;
}

}  // namespace slipstick
