#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "drivers/marlin/framing.h"
#include "drivers/marlin/position.h"

namespace slipstick {

/// Who wants a line executed: the sender, its owner, or the job.
enum class LineOwner : std::uint8_t { kSender, kHost, kJob };

/// The last `kCapacity` lines by number. A number never means another line that changes anything:
/// Marlin takes numbers in sequence only, so whatever is sent again, and however often, each is
/// executed once, in order.
class SentLines {
 public:
  /// More than a board holds (4 commands and 127 bytes) and than lines can be in doubt.
  static constexpr std::size_t kCapacity = 64;

  struct Entry {
    std::string text;
    std::uint64_t job_lines = 0;  ///< How many of the lines up to this one belong to the job.
    Position after;               ///< Where it leaves the printer.
    LineOwner owner = LineOwner::kSender;
  };

  /// \param first the number that the first line gets, at least 0.
  /// \param place where the lines before lead.
  explicit SentLines(LineNumber first = 0, PositionTracker place = {})
      : tracker_(std::move(place)), first_(first), highest_(first - 1) {}

  /// Gives `text` the next number, which is returned.
  LineNumber bind(std::string text, LineOwner owner);

  /// Puts a question that changes nothing before line `number`, which gets the next number, as all
  /// behind it do. \pre has(number - 1) and has(number), the printer refused `number`, and nothing
  /// is under way to it.
  void insert_question(LineNumber number, std::string text);

  /// Line `number` was executed without its number: what is sent under it is a question instead.
  /// \pre as of insert_question.
  void settle(LineNumber number);

  /// The printer reports where line `number` left it. Changes nothing unless that is the last.
  void learn(LineNumber number, const Position& report);

  /// Where the last line leads is not known, and the next ones will not tell.
  [[nodiscard]] bool lost() const { return tracker_.lost(); }

  /// The greatest number bound; one less than the first before that.
  [[nodiscard]] LineNumber highest() const { return highest_; }

  /// Whether line `number` is still kept.
  [[nodiscard]] bool has(LineNumber number) const;

  /// \pre has(number).
  [[nodiscard]] const Entry& at(LineNumber number) const;

 private:
  std::array<Entry, kCapacity> ring_;
  PositionTracker tracker_;
  LineNumber first_;
  LineNumber highest_;
};

}  // namespace slipstick
