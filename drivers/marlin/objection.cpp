#include "drivers/marlin/objection.h"

#include <algorithm>
#include <array>

namespace slipstick {
namespace {

/// Marlin's words (language.h, 1.1.9 and 2.1.2) and, of moves before homing, "Home XYZ First" with
/// the axes that were not homed.
constexpr std::array<std::string_view, 5> kNotDone{
    "cold extrusion prevented", "too long extrusion prevented", "Invalid extruder",
    "Printer locked!", "G2/G3 bad parameters"};

bool wants_homing(std::string_view text) {
  return text.starts_with("Home ") && text.ends_with(" First");
}

}  // namespace

Objection objection_in(std::string_view text) {
  const auto names = [&](std::string_view words) { return text.find(words) != text.npos; };
  if (text.starts_with("Unknown command:")) return Objection::kUnknown;
  if (text.starts_with("M105 ")) return Objection::kNone;  // a question without an answer
  if (std::ranges::any_of(kNotDone, names) || wants_homing(text)) return Objection::kNotDone;
  return Objection::kNone;
}

}  // namespace slipstick
