#include "host/resume_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/gcode/parse.h"

namespace slipstick {
namespace {

/// Lines that a board has taken and may not have executed when its power went: 16 moves and 4
/// commands.
constexpr std::uint64_t kUnderWay = 20;
constexpr LineNumber kBeyond = 1'000'000;
constexpr std::chrono::milliseconds kWait{20};
constexpr std::chrono::seconds kWritePatience{5};

bool moves(const OtherLine& line) {
  const auto command = parse_gcode(line.text);
  return command && command->letter() == 'G' && (command->code() <= 3 || command->code() == 28);
}

// The last lines sent may have moved the nozzle off the print: nothing tells how high it stands.
bool was_under_way(const JournalSession& session, std::uint64_t taken) {
  if (session.others.empty()) return false;
  const LineNumber last = session.others.back().number;
  return session.job_lines(last) >= taken && std::ranges::any_of(session.tail(last), moves);
}

std::optional<LayerMark> layer_of(const JournalContent& journal, std::uint64_t line) {
  const auto beyond = std::ranges::upper_bound(journal.layers, line, {}, &LayerMark::line);
  if (beyond == journal.layers.begin()) return {};
  return *(beyond - 1);
}

std::string place_text(const Position& place) {
  std::string text;
  constexpr std::string_view kAxes = "XYZ";
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (place[axis]) text += fmt::format(" {}{:.2f}", kAxes[axis], *place[axis]);
  }
  return text.empty() ? " nowhere" : text;
}

// The line of the job that the board stands at, if it still has the count of the print.
std::optional<std::uint64_t> kept_line(const JournalContent& journal,
                                       const std::optional<SessionProbe::Found>& found) {
  if (!found || journal.end != JournalEnd::kCutOff) return {};
  if (found->last < journal.session->first) return {};
  const std::uint64_t line = journal.session->job_lines(found->last);
  return line < journal.taken ? std::nullopt : std::optional(line);
}

tl::unexpected<Error> needs_consent(const JournalContent& journal, std::uint64_t line) {
  const auto layer = layer_of(journal, line);
  const std::string where = layer ? fmt::format("layer {}, ", layer->layer) : std::string();
  return fail(
      ErrorCode::kInput,
      fmt::format("the printer has been reset, or used by somebody else, since the print was cut "
                  "off at {}line {}. If the part still holds on the bed and the nozzle is still at "
                  "its height, it can be recovered (--recover): the nozzle heats up where it is, "
                  "lifts, X and Y are homed, and the print goes on {} lines before",
                  where, line, kUnderWay));
}

Result<ResumePoint> recovery_point(const JournalContent& journal, Consent consent) {
  if (was_under_way(*journal.session, journal.taken)) {
    return fail(ErrorCode::kInput,
                "the printer was reset while its nozzle was parked or on its way: how high it "
                "stands is not known; clear the bed and start the print again");
  }
  if (consent == Consent::kNone) return needs_consent(journal, journal.taken);
  const std::uint64_t line = journal.taken - std::min(journal.taken, kUnderWay);
  return ResumePoint{line, layer_of(journal, line), {}};
}

// Mm of filament that lines between those of the job have drawn back.
double drawn_back(const std::vector<OtherLine>& lines, const PrintState& at) {
  PrintState from = at;
  from.position[3] = from.position[3].value_or(0);
  PrintStateTracker tracker(from);
  for (const OtherLine& line : lines) tracker.follow(line.text);
  const auto& e = tracker.state().position[3];
  return e ? *from.position[3] - *e : 0;
}

Result<ResumeStart> go_on(const SessionProbe::Found& found, const JournalSession& session,
                          const PrintStateTracker& state, const ParkingPlace& place) {
  const std::vector<OtherLine> tail = session.tail(found.last);
  PrintStateTracker now = state;
  for (const OtherLine& line : tail) now.follow(line.text);
  const bool recovering = knows_place(state.state()) && !knows_place(now.state());
  if (recovering || !fits(found.position, now.state().position)) {
    return fail(ErrorCode::kInput,
                fmt::format("the printer goes on with the count of this print, but its nozzle is "
                            "at{}, and not at{} where the print left it; move it back there by the "
                            "printer's own menu and try again",
                            place_text(found.position), place_text(now.state().position)));
  }
  ResumeStart start;
  now.learn(found.position);
  start.sender.kept = KeptSession{found.last, now.place()};
  const PrintState& left = now.state();
  const bool same_modes = left.relative == state.state().relative &&
                          left.relative_extrusion == state.state().relative_extrusion;
  if (same_modes && std::ranges::none_of(tail, moves)) {
    start.lines = heating_lines(state.state());
  } else {
    ParkingPlace from = place;
    from.retraction = drawn_back(tail, state.state());
    start.lines = returning_lines(state.state(), from);
  }
  return start;
}

}  // namespace

Result<std::optional<SessionProbe::Found>> find_session(Transport& transport, const Clock& clock,
                                                        LineNumber beyond) {
  SessionProbe probe(beyond);
  std::array<char, 4096> buffer{};
  while (true) {
    const std::string question = probe.take_output(clock.now());
    if (probe.state() == SessionProbe::State::kFound) return probe.found();
    if (probe.state() != SessionProbe::State::kAsking) return std::nullopt;
    if (!question.empty()) {
      if (const auto ok = transport.write_all(question, kWritePatience); !ok)
        return fail(ok.error());
    }
    const auto got = transport.read_some(buffer, kWait);
    if (got) {
      probe.receive({buffer.data(), *got}, clock.now());
    } else if (got.error().code != ErrorCode::kTimedOut) {
      return fail(got.error());
    }
  }
}

LineNumber beyond(const JournalContent& journal) {
  const auto& session = journal.session;
  if (!session) return kBeyond;
  const LineNumber last = session->others.empty() ? session->first : session->others.back().number;
  return last + static_cast<LineNumber>(journal.taken) + kBeyond;
}

Result<ResumePoint> resume_point(const JournalContent& journal,
                                 const std::optional<SessionProbe::Found>& found, Consent consent) {
  if (journal.end == JournalEnd::kFinished) {
    return fail(ErrorCode::kInput, "this print was finished; there is nothing to take up");
  }
  const auto line = journal.session ? kept_line(journal, found) : std::nullopt;
  if (line) return ResumePoint{*line, layer_of(journal, *line), found};
  if (!journal.session || journal.taken <= kUnderWay) {
    return fail(ErrorCode::kInput,
                "nothing of this print is known to have been laid; remove the journal and start "
                "the print again");
  }
  return recovery_point(journal, consent);
}

Result<ResumeStart> resume_start(const ResumePoint& point, const JournalContent& journal,
                                 const PrintStateTracker& state, const ParkingPlace& place) {
  if (point.kept) return go_on(*point.kept, *journal.session, state, place);
  if (!knows_place(state.state()) || state.state().renamed) {
    return fail(ErrorCode::kInput,
                "where the nozzle was when the print was cut off is not known; clear the bed and "
                "start the print again");
  }
  return ResumeStart{{}, recovering_lines(state.state(), place)};
}

}  // namespace slipstick
