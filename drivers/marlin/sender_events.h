#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "drivers/marlin/framing.h"
#include "drivers/marlin/temperatures.h"

namespace slipstick {

/// \file
/// What the sender tells its owner.

/// What the sender is at.
enum class SenderState : std::uint8_t {
  kGreeting,   ///< Finding out who is there.
  kReady,      ///< Idle; no line of a job was given yet.
  kPrinting,   ///< Lines flow.
  kResending,  ///< Something went wrong; the truth is being found out and lines are sent again.
  kWaiting,    ///< The printer is at a blocking command.
  kDone,       ///< Every line of the job was surely accepted. Another job may follow.
  kHalted,     ///< The printer has killed itself, or was told to. Only a reset helps.
  kLost,  ///< The printer was reset, or does not answer, or answers nonsense. Nothing of the job is
          ///< sent any more; for a while the printer is told to switch off its heaters.
};

/// The printer's name, from M115.
struct FirmwareSeen {
  std::string name;
  friend bool operator==(const FirmwareSeen&, const FirmwareSeen&) = default;
};

/// A temperature report.
struct TemperaturesSeen {
  Temperatures temperatures;
  friend bool operator==(const TemperaturesSeen&, const TemperaturesSeen&) = default;
};

/// The printer wants `line` next, and gets it again.
struct ResendSeen {
  LineNumber line = 0;
  friend bool operator==(const ResendSeen&, const ResendSeen&) = default;
};

/// The printer was silent and was asked where it is.
struct ProbeSent {
  LineNumber line = 0;
  friend bool operator==(const ProbeSent&, const ProbeSent&) = default;
};

/// A text for people: `echo:` and harmless `Error:` lines.
struct MessageSeen {
  std::string text;
  friend bool operator==(const MessageSeen&, const MessageSeen&) = default;
};

/// What the printer says that is none of the protocol's: an answer to a line of the owner (a
/// position, a table, switches), or a line that was damaged on its way.
struct AnswerSeen {
  std::string text;
  friend bool operator==(const AnswerSeen&, const AnswerSeen&) = default;
};

/// The printer asks for something: "pause", "cancel", …
struct ActionSeen {
  std::string text;
  friend bool operator==(const ActionSeen&, const ActionSeen&) = default;
};

/// The state became kHalted or kLost.
struct SenderStopped {
  std::string reason;
  friend bool operator==(const SenderStopped&, const SenderStopped&) = default;
};

/// The lines are counted from `first` on, the number of an M110. Told before it is sent.
struct SessionBegun {
  LineNumber first = 0;
  friend bool operator==(const SessionBegun&, const SessionBegun&) = default;
};

/// `line` is no line of the job, but one of the sender's own (no text) or of its owner. Told before
/// it is sent.
struct LineBound {
  LineNumber line = 0;
  std::string text;
  friend bool operator==(const LineBound&, const LineBound&) = default;
};

/// A question got number `line`; what had that and all behind it move up by one. Told before it is
/// sent.
struct QuestionInserted {
  LineNumber line = 0;
  friend bool operator==(const QuestionInserted&, const QuestionInserted&) = default;
};

/// Nothing at all was heard from the printer: it may have killed itself, and then only a reset
/// wakes it. Told once, in the greeting, and followed by another listening for the banner.
struct ResetWanted {
  friend bool operator==(const ResetWanted&, const ResetWanted&) = default;
};

using SenderEvent =
    std::variant<FirmwareSeen, TemperaturesSeen, ResendSeen, ProbeSent, MessageSeen, AnswerSeen,
                 ActionSeen, SenderStopped, SessionBegun, LineBound, QuestionInserted, ResetWanted>;

struct SenderCounters {
  std::uint64_t lines_sent = 0;  ///< Lines of the job that were sent, each counted once.
  std::uint64_t lines_acknowledged =
      0;                             ///< Lines of the job the printer is believed to have taken.
  std::uint64_t lines_sure = 0;      ///< Lines of the job that it has surely taken.
  std::uint64_t lines_behind = 0;    ///< Lines of any kind sent before the one before was answered.
  std::uint64_t resends = 0;         ///< Lines sent again, of any kind.
  std::uint64_t ghosts = 0;          ///< Lines executed without their number, not sent again.
  std::uint64_t probes = 0;          ///< Questions after a silence.
  std::uint64_t surplus_oks = 0;     ///< `ok`s that answered nothing.
  std::uint64_t unreadable = 0;      ///< Replies nobody understood, most of them damaged.
  std::uint64_t events_dropped = 0;  ///< Because nobody took them.
};

}  // namespace slipstick
