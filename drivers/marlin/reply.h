#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "drivers/marlin/framing.h"
#include "drivers/marlin/position.h"
#include "drivers/marlin/temperatures.h"

namespace slipstick {

/// \file
/// What a Marlin says, one line at a time.

/// `ok`, with whatever stands behind it.
struct Ok {
  std::optional<LineNumber> line;    ///< ADVANCED_OK: the command this answers.
  std::optional<int> free_moves;     ///< ADVANCED_OK's P.
  std::optional<int> free_commands;  ///< ADVANCED_OK's B.
  std::optional<Temperatures> temperatures;
  bool bare = true;  ///< Nothing stands behind it.

  friend bool operator==(const Ok&, const Ok&) = default;
};

/// `Resend: 23`; no number when it is unreadable.
struct Resend {
  std::optional<LineNumber> line;
  friend bool operator==(const Resend&, const Resend&) = default;
};

/// `Error:checksum mismatch, Last Line: 22`; no number when it is unreadable.
struct LineError {
  std::optional<LineNumber> last_line;
  std::string text;
  friend bool operator==(const LineError&, const LineError&) = default;
};

/// The printer has stopped for good: `kill()`, a heater out of control. Only a reset helps.
struct Fatal {
  std::string text;
  friend bool operator==(const Fatal&, const Fatal&) = default;
};

/// Any other `Error:`. The printer goes on and answers the command with `ok` all the same.
struct ErrorText {
  std::string text;
  friend bool operator==(const ErrorText&, const ErrorText&) = default;
};

/// `echo:busy: …`: a command is still at work.
struct Busy {
  std::string reason;
  friend bool operator==(const Busy&, const Busy&) = default;
};

/// `echo:Unknown command: "…"`: a command was not understood; `ok` follows.
struct UnknownCommand {
  std::string text;
  friend bool operator==(const UnknownCommand&, const UnknownCommand&) = default;
};

/// Any other `echo:` or comment.
struct Echo {
  std::string text;
  friend bool operator==(const Echo&, const Echo&) = default;
};

/// `// action:…`: the printer asks the host for something.
struct Action {
  std::string text;
  friend bool operator==(const Action&, const Action&) = default;
};

/// `X:0.00 Y:0.00 Z:0.00 E:0.00 Count …`, from M114. All four are there.
struct PositionReport {
  Position position;
  friend bool operator==(const PositionReport&, const PositionReport&) = default;
};

/// The line of M115 with the firmware's name.
struct FirmwareName {
  std::string name;
  friend bool operator==(const FirmwareName&, const FirmwareName&) = default;
};

/// `Cap:AUTOREPORT_TEMP:1`.
struct Capability {
  std::string name;
  bool on = false;
  friend bool operator==(const Capability&, const Capability&) = default;
};

/// The board has just been reset: `start`, or a later line of the banner, which may tell why.
struct Start {
  std::string cause;  ///< "Brown out Reset", "PowerUp"; empty where the line tells none.
  friend bool operator==(const Start&, const Start&) = default;
};

/// `wait`: the printer has nothing to do and nothing in its buffers.
struct Wait {
  friend bool operator==(const Wait&, const Wait&) = default;
};

/// Anything else: tables, or a line damaged on its way.
struct Unknown {
  std::string text;
  friend bool operator==(const Unknown&, const Unknown&) = default;
};

using Reply =
    std::variant<Ok, Resend, LineError, Fatal, ErrorText, Busy, UnknownCommand, Echo, Action,
                 PositionReport, FirmwareName, Capability, Temperatures, Start, Wait, Unknown>;

/// Reads one line without its end. Total: every line is a reply, if only an `Unknown` one.
[[nodiscard]] Reply parse_reply(std::string_view line);

}  // namespace slipstick
