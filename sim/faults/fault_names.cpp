#include "sim/faults/fault_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/base/rng.h"
#include "sim/faults/board_faults.h"
#include "sim/faults/line_faults.h"
#include "sim/faults/silences.h"

namespace slipstick {

namespace {

using Made = std::unique_ptr<Fault>;
using Bytes = ByteFault::Kind;
using Lines = LineFault::Kind;
using Which = LineFault::Which;
using enum WireSide;

constexpr double kLongest = 86'400;

template <WireSide side, Bytes kind>
Made bytes(const FaultSpec& spec, const FaultWhen& when, std::uint64_t seed) {
  return std::make_unique<ByteFault>(when, side, kind, spec.number(), seed);
}

template <WireSide side, Which which, Lines kind>
Made lines(const FaultSpec& spec, const FaultWhen& when, std::uint64_t seed) {
  return std::make_unique<LineFault>(when, side, which, kind, spec.number(), seed);
}

/// For as long as its value says, if no end is told.
template <class Spell>
Made spell(const FaultSpec& spec, const FaultWhen& when, std::uint64_t) {
  FaultWhen lasting = when;
  if (!lasting.lasts) lasting.lasts = Moment(static_cast<Moment::rep>(spec.number() * 1e6));
  return std::make_unique<Spell>(lasting);
}

template <class State>
Made state(const FaultSpec&, const FaultWhen& when, std::uint64_t) {
  return std::make_unique<State>(when);
}

template <ResetCause cause>
Made reset(const FaultSpec&, const FaultWhen& when, std::uint64_t) {
  return std::make_unique<Reset>(when, cause);
}

template <Heater Machine::*heater, HeaterDefect defect>
Made broken(const FaultSpec&, const FaultWhen& when, std::uint64_t) {
  return std::make_unique<BrokenHeater>(when, heater, defect);
}

template <WireSide side>
Made words(const FaultSpec& spec, const FaultWhen& when, std::uint64_t) {
  return std::make_unique<Words>(when, side, spec.words() + "\n");
}

Made late(const FaultSpec& spec, const FaultWhen& when, std::uint64_t) {
  return std::make_unique<Late>(when, Moment(static_cast<Moment::rep>(spec.number() * 1e6)));
}

constexpr auto kNone = FaultValue::kNone;
constexpr auto kShare = FaultValue::kShare;
constexpr auto kSeconds = FaultValue::kSeconds;
constexpr auto kWords = FaultValue::kWords;

constexpr std::array kNames = std::to_array<FaultName>({
    {"flip-rx", kShare, 0.001, 1, "a bit of a byte to the board flips",
     bytes<kToBoard, Bytes::kFlipped>},
    {"flip-tx", kShare, 0.001, 1, "a bit of a byte to the host flips",
     bytes<kToHost, Bytes::kFlipped>},
    {"lose-rx", kShare, 0.001, 1, "a byte to the board is lost", bytes<kToBoard, Bytes::kLost>},
    {"lose-tx", kShare, 0.001, 1, "a byte to the host is lost", bytes<kToHost, Bytes::kLost>},
    {"double-rx", kShare, 0.001, 1, "a byte to the board comes twice",
     bytes<kToBoard, Bytes::kDoubled>},
    {"double-tx", kShare, 0.001, 1, "a byte to the host comes twice",
     bytes<kToHost, Bytes::kDoubled>},
    {"lose-line-rx", kShare, 0.01, 1, "a line to the board is lost",
     lines<kToBoard, Which::kAll, Lines::kLost>},
    {"double-line-rx", kShare, 0.01, 1, "a line to the board comes twice",
     lines<kToBoard, Which::kAll, Lines::kDoubled>},
    {"garble-line-rx", kShare, 0.01, 1, "a line to the board is noise",
     lines<kToBoard, Which::kAll, Lines::kGarbled>},
    {"lose-line-tx", kShare, 0.01, 1, "a line to the host is lost",
     lines<kToHost, Which::kAll, Lines::kLost>},
    {"double-line-tx", kShare, 0.01, 1, "a line to the host comes twice",
     lines<kToHost, Which::kAll, Lines::kDoubled>},
    {"garble-line-tx", kShare, 0.01, 1, "a line to the host is noise",
     lines<kToHost, Which::kAll, Lines::kGarbled>},
    {"glue-tx", kShare, 0.01, 1, "a line to the host has lost its end",
     lines<kToHost, Which::kAll, Lines::kGlued>},
    {"lose-ok", kShare, 0.01, 1, "an ok is lost", lines<kToHost, Which::kOk, Lines::kLost>},
    {"double-ok", kShare, 0.01, 1, "an ok comes twice",
     lines<kToHost, Which::kOk, Lines::kDoubled>},
    {"garble-ok", kShare, 0.01, 1, "an ok is noise", lines<kToHost, Which::kOk, Lines::kGarbled>},
    {"lose-resend", kShare, 0.5, 1, "a request for a line is lost",
     lines<kToHost, Which::kResend, Lines::kLost>},
    {"double-resend", kShare, 0.5, 1, "a request for a line comes twice",
     lines<kToHost, Which::kResend, Lines::kDoubled>},
    {"wrong-resend", kShare, 0.5, 1, "another line is asked for than the one that is missing",
     lines<kToHost, Which::kResend, Lines::kMisnumbered>},
    {"late", kSeconds, 1, kLongest, "what the board says comes so many seconds later", late},
    {"mute", kSeconds, kLongest, kLongest, "the host hears nothing of the board", spell<Mute>},
    {"deaf", kSeconds, kLongest, kLongest, "the board hears nothing of the host", spell<Deaf>},
    {"freeze", kSeconds, kLongest, kLongest,
     "the firmware stands; heaters keep the power that they have", spell<Freeze>},
    {"unplug", kSeconds, kLongest, kLongest, "the cable is out, the board goes on", spell<Unplug>},
    {"reset", kNone, 0, 0, "the reset button is pressed", reset<ResetCause::kButton>},
    {"silent-reset", kNone, 0, 0, "the board starts anew and nobody hears it",
     reset<ResetCause::kUnheard>},
    {"brown-out", kNone, 0, 0, "the supply sags and the board starts anew",
     reset<ResetCause::kBrownOut>},
    {"watchdog", kNone, 0, 0, "the firmware hung and starts anew", reset<ResetCause::kWatchdog>},
    {"kill", kNone, 0, 0, "the firmware stops of itself", state<Kill>},
    {"say", kWords, 0, 0, "the board says these words", words<kToHost>},
    {"hear", kWords, 0, 0, "another program sends the board these words", words<kToBoard>},
    {"nozzle-open", kNone, 0, 0, "the nozzle's sensor comes off its cable",
     broken<&Machine::nozzle, HeaterDefect::kSensorOpen>},
    {"nozzle-short", kNone, 0, 0, "the wires of the nozzle's sensor touch",
     broken<&Machine::nozzle, HeaterDefect::kSensorShorted>},
    {"nozzle-cold", kNone, 0, 0, "no power reaches the nozzle's heater",
     broken<&Machine::nozzle, HeaterDefect::kCold>},
    {"nozzle-stuck", kNone, 0, 0, "the nozzle's heater cannot be turned off",
     broken<&Machine::nozzle, HeaterDefect::kStuck>},
    {"bed-open", kNone, 0, 0, "the bed's sensor comes off its cable",
     broken<&Machine::bed, HeaterDefect::kSensorOpen>},
    {"bed-short", kNone, 0, 0, "the wires of the bed's sensor touch",
     broken<&Machine::bed, HeaterDefect::kSensorShorted>},
    {"bed-cold", kNone, 0, 0, "no power reaches the bed's heater",
     broken<&Machine::bed, HeaterDefect::kCold>},
    {"bed-stuck", kNone, 0, 0, "the bed's heater cannot be turned off",
     broken<&Machine::bed, HeaterDefect::kStuck>},
    {"runout", kNone, 0, 0, "the motor turns and no plastic comes; no sensor tells",
     state<NoFilament>},
});

std::string_view value_name(FaultValue value) {
  constexpr std::array<std::string_view, 4> kTexts{"", "=SHARE", "=SECONDS", "=WORDS"};
  return kTexts[static_cast<std::size_t>(value)];
}

/// What is there all the time unless a time is told.
bool is_lasting(const FaultName& name) {
  return name.value == FaultValue::kShare || name.name == "late";
}

}  // namespace

std::span<const FaultName> fault_names() {
  return kNames;
}

std::string list_of_faults() {
  std::string list;
  for (const FaultName& name : kNames) list.append(list.empty() ? "" : ", ").append(name.name);
  return list;
}

std::string help_on_faults() {
  std::string help;
  for (const FaultName& name : kNames) {
    const std::string form = fmt::format("{}{}", name.name, value_name(name.value));
    help += fmt::format("  {:<24}{}\n", form, name.what);
  }
  return help;
}

std::unique_ptr<Fault> make_fault(const FaultSpec& spec, std::uint64_t seed) {
  const auto* name = std::ranges::find(kNames, std::string_view(spec.name()), &FaultName::name);
  SLIPSTICK_CHECK(name != kNames.end());
  Rng rng(seed);
  FaultWhen when = spec.when();
  if (!when.from && !when.line) {
    const auto span =
        static_cast<std::uint64_t>((FaultName::kLatest - FaultName::kEarliest).count());
    const Moment drawn = FaultName::kEarliest + Moment(static_cast<Moment::rep>(rng.below(span)));
    when.from = is_lasting(*name) ? Moment(0) : drawn;
  }
  return name->make(spec, when, rng.next());
}

}  // namespace slipstick
