#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "drivers/transport.h"

namespace spdlog {
class logger;
}

namespace slipstick {

/// All that goes to the printer and comes from it, line by line, with the time, in two files that
/// take turns: `serial.log` and, older, `serial.1.log`. Only while somebody wants it. A disk that
/// takes no more costs lines of it, never the print.
///
/// Threads: one uses the printer; the rest, any.
class SerialLog {
 public:
  static constexpr std::size_t kFileMost = std::size_t{16} << 20;  ///< Of one file.
  static constexpr std::size_t kTailMost = std::size_t{1} << 20;

  explicit SerialLog(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// \return kUnavailable if the file cannot be written.
  [[nodiscard]] Result<void> start();
  void stop();
  [[nodiscard]] bool is_on() const;
  /// The end of it, from the beginning of a line; empty if there is none.
  [[nodiscard]] Result<std::string> tail() const;

  /// By the thread that uses the printer.
  void sent(std::string_view bytes) { add('>', to_printer_, bytes); }
  void received(std::string_view bytes) { add('<', from_printer_, bytes); }

 private:
  void add(char direction, std::string& begun, std::string_view bytes);
  [[nodiscard]] std::shared_ptr<spdlog::logger> lines() const;
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "serial.log"; }

  const std::filesystem::path folder_;
  std::string to_printer_;    // the printing thread's: a line that is not complete yet
  std::string from_printer_;  // likewise
  mutable std::mutex mutex_;  ///< Protects what follows.
  std::shared_ptr<spdlog::logger> lines_;
};

/// A printer's transport whose bytes are told to a log.
class LoggedTransport final : public Transport {
 public:
  LoggedTransport(std::unique_ptr<Transport> printer, SerialLog& log)
      : printer_(std::move(printer)), log_(log) {}

  [[nodiscard]] Result<std::size_t> read_some(std::span<char> buffer,
                                              std::chrono::microseconds patience) override;
  [[nodiscard]] Result<std::size_t> write_some(std::string_view bytes,
                                               std::chrono::microseconds patience) override;
  [[nodiscard]] Result<void> write_all(std::string_view bytes,
                                       std::chrono::microseconds patience) override;
  void discard_output() noexcept override { printer_->discard_output(); }
  bool set_dtr(bool on) noexcept override { return printer_->set_dtr(on); }
  void shut_down() noexcept override { printer_->shut_down(); }
  [[nodiscard]] int descriptor() const noexcept override { return printer_->descriptor(); }
  [[nodiscard]] std::string_view name() const override { return printer_->name(); }

 private:
  const std::unique_ptr<Transport> printer_;
  SerialLog& log_;
};

}  // namespace slipstick
