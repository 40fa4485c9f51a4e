#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/clock.h"

namespace slipstick::test {

/// One line of what a host and a printer said to each other.
struct TranscriptLine {
  enum class Kind : std::uint8_t {
    kHost,
    kPrinter,
    kBench,  ///< What was done to the printer or its cable: "reset".
  };

  Kind kind = Kind::kHost;
  std::optional<Moment> at;  ///< When, if it was written down; since power on or any other moment.
  std::string text;          ///< Bytes. The host's with their line ends, the printer's without.
  int number = 0;            ///< Of the line in the file, from 1.
};

/// Reads lines of the form `[SECONDS] MARK TEXT`: `>` is said by the host, `<` by the printer, `!`
/// is done to the printer. A mark may be doubled; after `#` is a comment, but "control: X" in one
/// is done to the printer. `\n`, `\r`, `\\` and `\xHH` in a text are bytes; what the host says ends
/// with a line end where none is written. Anything else is not read.
[[nodiscard]] std::vector<TranscriptLine> read_transcript(std::string_view text);

}  // namespace slipstick::test
