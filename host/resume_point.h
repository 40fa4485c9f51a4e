#pragma once

#include <optional>
#include <vector>

#include "drivers/marlin/park.h"
#include "drivers/marlin/sender.h"
#include "drivers/marlin/session_probe.h"
#include "drivers/transport.h"
#include "host/print_journal.h"

namespace slipstick {

/// \file
/// Where a print that was cut off goes on, and how.

/// What may be done where the board does not go on with the count of the print.
enum class Consent : std::uint8_t {
  kNone,     ///< Nothing.
  kRecover,  ///< Home X and Y, heat, prime; the nozzle stands at the height where the print ended.
};

struct ResumePoint {
  std::uint64_t line = 0;          ///< Lines of the job before the first that is sent.
  std::optional<LayerMark> layer;  ///< Where making lines begins; without one, at the very first.
  std::optional<SessionProbe::Found> kept;  ///< The board goes on with its count.
};

/// Asks the printer where it stands. \return nothing if it was reset or does not answer.
[[nodiscard]] Result<std::optional<SessionProbe::Found>> find_session(Transport& transport,
                                                                      const Clock& clock,
                                                                      LineNumber beyond);

/// A number that no line of the journal's session has.
[[nodiscard]] LineNumber beyond(const JournalContent& journal);

/// \return kInput if the print cannot be taken up, or not without consent: why, and what to do.
[[nodiscard]] Result<ResumePoint> resume_point(const JournalContent& journal,
                                               const std::optional<SessionProbe::Found>& found,
                                               Consent consent);

/// What is sent before the first line, and how.
struct ResumeStart {
  SenderOptions sender;
  std::vector<Line> lines;
};

/// \param state after the lines before `point.line`.
/// \return kInput if the nozzle is not where these lines lead.
[[nodiscard]] Result<ResumeStart> resume_start(const ResumePoint& point,
                                               const JournalContent& journal,
                                               const PrintStateTracker& state,
                                               const ParkingPlace& place);

}  // namespace slipstick
