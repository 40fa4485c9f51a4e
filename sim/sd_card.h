#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/gcode/parse.h"

namespace slipstick {

/// The memory card of a printer, with what hosts ask of it (SDSUPPORT of Marlin 2.1.2): M20 to M30.
/// It holds what a host writes to it.
class SdCard {
 public:
  static constexpr std::size_t kBytesMax = 4U << 20U;  ///< Of all files; more is not written.

  /// Takes `line` into the file being written. \return Whether there is one; M29 ends it.
  [[nodiscard]] bool writes(std::string_view line);

  /// Runs M20 to M30. \return What it prints; nothing if it is another command.
  [[nodiscard]] std::optional<std::string> run(const GcodeCommand& command);

  /// The board starts anew: nothing is written or printed any more.
  void reset() {
    writing_.clear();
    printing_ = false;
  }

  [[nodiscard]] bool prints() const { return printing_; }

  /// The next line of the file that is being printed, with what has to be said at its end; nothing
  /// if none is.
  struct Next {
    std::optional<std::string> line;
    std::string_view said;
  };
  [[nodiscard]] std::optional<Next> next();

 private:
  [[nodiscard]] std::string list() const;
  [[nodiscard]] std::string open(std::string_view name);
  [[nodiscard]] std::string status() const;
  [[nodiscard]] std::size_t bytes() const;

  std::map<std::string, std::string> files_;
  std::string writing_;   ///< Name of the file being written; empty is none.
  std::string selected_;  ///< And of the one that M23 opened.
  std::size_t at_ = 0;    ///< Of it, the next byte.
  bool printing_ = false;
  bool mounted_ = true;
};

}  // namespace slipstick
