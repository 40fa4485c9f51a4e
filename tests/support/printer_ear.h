#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "sim/printer.h"

namespace slipstick::test {

/// Listens to a simulated printer line by line, and lets its time pass meanwhile.
class PrinterEar {
 public:
  struct Heard {
    Moment at;         ///< When its line end came.
    std::string text;  ///< Without it.
  };

  explicit PrinterEar(const PrinterOptions& options) : printer_(options) {}

  /// The next line, if one comes by `deadline`; else the time is `deadline` or later.
  std::optional<Heard> next_line(Moment deadline) {
    while (true) {
      if (auto line = take_line()) return line;
      if (printer_.now() >= deadline) return std::nullopt;
      Moment to = deadline;
      if (const auto m = printer_.next_event()) to = std::min(to, *m);
      if (const auto m = printer_.output_at()) to = std::min(to, *m);
      printer_.advance(std::max(to, printer_.now() + Moment(1)));
      listen();
    }
  }

  [[nodiscard]] Printer& printer() { return printer_; }

 private:
  void listen() {
    std::array<char, 256> buffer{};
    while (const std::size_t count = printer_.take(buffer)) heard_.append(buffer.data(), count);
  }

  std::optional<Heard> take_line() {
    const std::size_t end = heard_.find('\n');
    if (end == std::string::npos) return std::nullopt;
    Heard line{printer_.now(), heard_.substr(0, end)};
    heard_.erase(0, end + 1);
    return line;
  }

  Printer printer_;
  std::string heard_;  ///< From the last line taken on.
};

}  // namespace slipstick::test
