#include "host/printer_words.h"

#include <string_view>
#include <variant>

#include "drivers/marlin/objection.h"

namespace slipstick {
namespace {

// "pause filament_runout 0" asks for a pause as "pause" does.
PrinterWords::Wish asked_by(std::string_view action) {
  using enum PrinterWords::Wish;
  const std::string_view word = action.substr(0, action.find(' '));
  if (word == "pause") return kPause;
  if (word == "paused") return kHold;
  if (word == "resume" || word == "resumed") return kGoOn;
  return word == "cancel" ? kCancel : kNone;
}

}  // namespace

PrinterWords::Heard PrinterWords::hear(const SenderEvent& event) {
  if (const auto* action = std::get_if<ActionSeen>(&event)) return {asked_by(action->text), ""};
  if (const auto* message = std::get_if<MessageSeen>(&event)) return hear_message(message->text);
  if (const auto* seen = std::get_if<TemperaturesSeen>(&event)) {
    if (auto fault = sensors_.follow(seen->temperatures)) return {Wish::kEnd, *std::move(fault)};
  }
  return {};
}

PrinterWords::Heard PrinterWords::hear_message(const std::string& text) {
  const Objection objection = objection_in(text);
  if (objection == Objection::kUnknown) ++unknown_;
  if (objection != Objection::kNotDone) return {};
  ++not_done_;
  return {Wish::kWait, "the printer did not do what it was sent: " + text};
}

}  // namespace slipstick
