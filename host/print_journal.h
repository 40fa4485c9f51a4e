#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/job/settings_change.h"
#include "drivers/marlin/framing.h"
#include "drivers/marlin/print_state.h"

namespace slipstick {

/// \file
/// What a journal of a print says: records of text, one a line, each with a checksum.
///
/// What it must tell is which line of the job a number means that the board says it has taken. So
/// the numbers that mean no line of the job are written before they are sent; all others follow.

/// Which print, and how it was asked for.
struct JournalHeader {
  std::string folder;              ///< Where `words` were said.
  std::vector<std::string> words;  ///< Behind `slipstick print`.
  std::uint32_t model = 0;         ///< Checksum of the file's bytes,
  std::uint32_t settings = 0;      ///< and of all settings.

  friend bool operator==(const JournalHeader&, const JournalHeader&) = default;
};

/// A layer is about to be sent.
struct LayerMark {
  int layer = 0;
  std::uint64_t line = 0;     ///< Lines of the job before it.
  std::uint32_t program = 0;  ///< Checksum of its G-code.
  PrintState state;           ///< Before its first line.

  friend bool operator==(const LayerMark&, const LayerMark&) = default;
};

/// A number that means no line of the job.
struct OtherLine {
  LineNumber number = 0;
  std::string text;  ///< Of lines that may move; else empty.

  friend bool operator==(const OtherLine&, const OtherLine&) = default;
};

/// One count of lines on a board, from an M110 on.
struct JournalSession {
  LineNumber first = 0;           ///< The number of the M110.
  std::uint64_t base = 0;         ///< Lines of the job before it.
  std::vector<OtherLine> others;  ///< Ascending.

  /// How many lines of the job a board has taken whose last number is `last`. \pre last >= first.
  [[nodiscard]] std::uint64_t job_lines(LineNumber last) const;
  /// The lines behind the last one of the job that lines up to `last` have, which may move.
  [[nodiscard]] std::vector<OtherLine> tail(LineNumber last) const;
};

enum class JournalEnd : std::uint8_t {
  kCutOff,    ///< Nobody wrote an end.
  kStopped,   ///< Heaters and motors were told to go off.
  kFinished,  ///< Everything was taken.
};

struct JournalContent {
  JournalHeader header;
  std::optional<JournalSession> session;  ///< The last.
  std::vector<LayerMark> layers;          ///< Ascending; none of a G-code file.
  std::vector<SettingsChange> changes;  ///< In order: of all layers that `layers` tells, and more.
  std::uint64_t taken = 0;              ///< So many lines of the job were surely taken.
  JournalEnd end = JournalEnd::kCutOff;
  std::size_t size = 0;  ///< Bytes of whole records; what stands behind was cut off.
};

/// Each ends with a newline.
[[nodiscard]] std::string header_record(const JournalHeader& header);
[[nodiscard]] std::string session_record(LineNumber first, std::uint64_t base);
[[nodiscard]] std::string other_record(LineNumber number, std::string_view text);
/// A question was put before `number`; that and all behind it move up by one.
[[nodiscard]] std::string inserted_record(LineNumber number);
[[nodiscard]] std::string layer_record(const LayerMark& mark);
/// Before the record of the first layer that has it.
[[nodiscard]] std::string change_record(const SettingsChange& change);
[[nodiscard]] std::string taken_record(std::uint64_t lines);
[[nodiscard]] std::string end_record(JournalEnd end);

/// Reads a journal. A record cut off at the end is ignored, as it is when power goes.
/// \return kInput if it is no journal, or a record before others is damaged; the message says
/// where.
[[nodiscard]] Result<JournalContent> parse_journal(std::string_view bytes);

}  // namespace slipstick
