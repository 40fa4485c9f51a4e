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

  /// \param first the number that the first line gets, at least 0.
  explicit SentLines(LineNumber first = 0) : first_(first), highest_(first - 1) {}

  /// Gives `text` the next number, which is returned.
  LineNumber bind(std::string text, LineOwner owner);

  /// Line `number` was executed without its number: what is sent under it again is a question that
  /// changes nothing. \pre has(number), and nothing is under way any more.
  void settle(LineNumber number);

  /// The greatest number bound; one less than the first before that.
  [[nodiscard]] LineNumber highest() const { return highest_; }

  /// Whether line `number` is still kept.
  [[nodiscard]] bool has(LineNumber number) const;

  /// \pre has(number).
  [[nodiscard]] const Entry& at(LineNumber number) const;

 private:
  std::array<Entry, kCapacity> ring_;
  LineNumber first_;
  LineNumber highest_;
};

}  // namespace slipstick
