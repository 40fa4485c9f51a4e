#pragma once

#include <cstdint>
#include <string_view>

namespace slipstick {

/// What becomes of a line that was received.
enum class Verdict : std::uint8_t {
  kAccepted,
  kDropped,  ///< Without a word: a number that was had already, or damaged where nobody asks again.
  kSkipped,  ///< A number that was had already, acknowledged as such.
  kWrongNumber,
  kWrongChecksum,
  kNoChecksum,
  kNoNumber,  ///< A checksum without a line number.
};

/// Which lines are held against the number before.
enum class NumberCheck : std::uint8_t {
  kInSequence,    ///< N at the start of a line.
  kAnyN,          ///< Any N in a line, as Marlin 1.0 finds it.
  kChecksumOnly,  ///< Only checksums; a damaged line is dropped without a word.
  kNone,          ///< Neither numbers nor checksums.
};

/// What a number that was had already means.
enum class Duplicates : std::uint8_t {
  kError,          ///< As any other wrong number.
  kDropLastTwo,    ///< The last and the last but one vanish without an answer.
  kSkipLastForty,  ///< "skip" and "ok".
};

/// What firmwares differ in when they look at numbers and checksums.
struct LineRules {
  NumberCheck numbers = NumberCheck::kInSequence;
  Duplicates duplicates = Duplicates::kDropLastTwo;
  bool first_star = false;         ///< The checksum follows the first star, not the last.
  bool star_needs_number = false;  ///< A checksum without a number is an error.
};

/// Line numbers and checksums in the order in which Marlin looks at them.
///
/// The number comes first: a line whose number was damaged is never told about its checksum, and
/// `M110` anywhere in the text switches the number check off.
class LineGate {
 public:
  explicit LineGate(const LineRules& rules = {}) : rules_(rules) {}

  /// Judges `line` and, if it is numbered and accepted, takes its number as the last one.
  Verdict judge(std::string_view line);

  [[nodiscard]] std::int64_t last_number() const { return last_number_; }
  /// The number of the last numbered line, accepted or not.
  [[nodiscard]] std::int64_t seen_number() const { return seen_number_; }
  /// What M110 N… does when it is executed.
  void set_last_number(std::int64_t number) { last_number_ = number; }

 private:
  /// What `number`, not the next one, is taken for.
  [[nodiscard]] Verdict out_of_sequence(std::int64_t number) const;
  [[nodiscard]] Verdict check(std::string_view line) const;

  LineRules rules_;
  std::int64_t last_number_ = 0;
  std::int64_t seen_number_ = 0;
};

/// The text between "Error:" and the last number, in Marlin's words. \pre `verdict` is an error.
[[nodiscard]] std::string_view error_text(Verdict verdict);

}  // namespace slipstick
