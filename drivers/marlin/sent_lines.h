#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "drivers/marlin/framing.h"

namespace slipstick {

/// Who wants a line printed.
enum class LineOwner : std::uint8_t { kSender, kJob };

/// The last `kCapacity` lines by number. Once bound, a number never means another line: Marlin
/// takes numbers in sequence only, so whatever is sent again, and however often, each is executed
/// once, in order.
class SentLines {
 public:
  /// More than a board holds (4 commands and 127 bytes) and than lines can be in doubt.
  static constexpr std::size_t kCapacity = 64;

  struct Entry {
    std::string text;
    std::uint64_t job_lines = 0;  ///< How many of the lines up to this one belong to the job.
  };

  /// Gives `text` the next number, which is 0 after construction and returned.
  LineNumber bind(std::string text, LineOwner owner);

  /// The greatest number bound, -1 before the first.
  [[nodiscard]] LineNumber highest() const { return highest_; }

  /// Whether line `number` is still kept.
  [[nodiscard]] bool has(LineNumber number) const;

  /// \pre has(number).
  [[nodiscard]] const Entry& at(LineNumber number) const;

 private:
  std::array<Entry, kCapacity> ring_;
  LineNumber highest_ = -1;
};

}  // namespace slipstick
