#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/clock.h"
#include "sim/line_gate.h"
#include "sim/machine.h"

namespace slipstick {

/// When a command is acknowledged.
enum class OkTime : std::uint8_t { kWhenDone, kWhenReceived };

/// Which lines with M112 (and M108) are obeyed when they are read, before their turn.
enum class EarlyStop : std::uint8_t {
  kPrefix,  ///< What begins with the code, without a line number.
  kExact,   ///< Nothing but the code.
  kBare,    ///< Nothing but the code, once line number and checksum are off.
};

/// Why the board starts.
enum class ResetCause : std::uint8_t {
  kPowerUp,
  kButton,
  kBrownOut,
  kWatchdog,
  kUnheard,  ///< Whatever it was: nothing of what the board says about it comes through.
};

/// In whose words a line is refused.
enum class Complaint : std::uint8_t { kMarlin, kRepetier, kNone };

/// How a firmware talks and counts, as data. Lines with their line ends; empty: it says nothing.
struct Personality {
  std::string_view name;  ///< As in `sim:?firmware=NAME`.
  std::string_view greeting;
  bool greets_with_settings;
  std::string_view identity;      ///< The line of M115; one that begins with "ok" is its own.
  std::string_view capabilities;  ///< NAME:0 or NAME:1, one space between them.
  LineRules lines;
  Complaint complaint;
  std::string_view resend;       ///< What stands before the number that is asked for.
  std::string_view resend_tail;  ///< The line after it.
  OkTime ok;
  EarlyStop early;
  std::string_view busy;      ///< Keep-alive while a handler runs.
  Moment wait_period;         ///< "wait" after so long without anything to do; 0 is never.
  std::string_view shutdown;  ///< Said first when M112 is obeyed.
  std::string_view killed;    ///< The last words, whatever the reason.
  std::size_t queue_max;      ///< Commands, the running one included.
  std::size_t line_max;       ///< Bytes of a line that are kept.
};

/// The firmware that is simulated when nothing else is said: Marlin 2.1.2.
[[nodiscard]] const Personality& default_personality();

/// The firmware of that name; nothing if there is none.
[[nodiscard]] std::optional<Personality> find_personality(std::string_view name);

/// All names, as a user is told them: "a, b, c".
[[nodiscard]] std::string personality_names();

/// What it says when it has booted, and to M115.
[[nodiscard]] std::string banner_report(const Personality& personality, const Machine& machine,
                                        ResetCause cause);
[[nodiscard]] std::string identity_report(const Personality& personality, const Features& features);

}  // namespace slipstick
