#pragma once

#include <string>
#include <vector>

#include "sim/printer.h"
#include "tests/support/transcript.h"
#include "tests/support/transcript_match.h"

namespace slipstick::test {

/// Where the simulated printer answered otherwise than the transcript says.
struct Difference {
  int line = 0;          ///< Of the file: where the host spoke last.
  std::string said;      ///< By the host; empty for what the printer says when it is switched on.
  std::string expected;  ///< The first line that differs; "nothing" where none more was expected.
  std::string heard;     ///< Instead of it; "nothing" where nothing more came.
};

/// "line 7: M105: expected …, heard …"
[[nodiscard]] std::string text_of(const Difference& difference);

/// Says the host's lines of `lines` to a printer with `options`, each when all answers to those
/// before have come and as much later as is written, and compares what it hears line by line.
///
/// Where no times are written, an answer is waited for 10 minutes, and what should not come 0.1 s.
/// The bench's "reset", and times that go back other than behind "port gone", switch the printer
/// off and on again; "nozzle open", "bed short", "cold" or "stuck" break a heater; "say X" says it
/// in the printer's place; the cable is harmed by what bench_cable.h tells. A banner that is not
/// written down is not compared.
[[nodiscard]] std::vector<Difference> play_transcript(const std::vector<TranscriptLine>& lines,
                                                      const PrinterOptions& options,
                                                      const Tolerance& tolerance = {});

}  // namespace slipstick::test
