#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/printer.h"

namespace slipstick {

/// A host that sends lines to a printer and collects what it says.
class Dialogue {
 public:
  explicit Dialogue(const PrinterOptions& options = {}, const Planner::Sink& sink = {})
      : printer_(options, sink) {
    listen(Moment(1'000'000));
  }

  /// Sends `line` and a line end, listens for `time`, gives back what came.
  std::string say(std::string_view line, Moment time = Moment(100'000)) {
    return send(std::string(line) + "\n", time);
  }

  /// Sends `bytes` as they are.
  std::string send(std::string_view bytes, Moment time = Moment(100'000)) {
    printer_.receive(bytes, printer_.now());
    return listen(time);
  }

  std::string listen(Moment time) {
    printer_.advance(printer_.now() + time);
    std::string heard;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = printer_.take(buffer)) heard.append(buffer.data(), count);
    return heard;
  }

  [[nodiscard]] Printer& printer() { return printer_; }

 private:
  Printer printer_;
};

inline constexpr Moment kSecond{1'000'000};

}  // namespace slipstick
