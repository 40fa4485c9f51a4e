#include "drivers/marlin/park.h"

#include <algorithm>
#include <string>

#include "core/base/number_text.h"

namespace slipstick {
namespace {

constexpr double kExtrudable = 170;  // °C: Marlin moves no filament in a nozzle that is colder
constexpr double kSecondsPerMinute = 60;
constexpr int kDecimals = 5;
constexpr double kPrime = 20;      // mm of filament: what has oozed and burnt meanwhile
constexpr double kPrimeSpeed = 5;  // mm/s

// "G0" and words: a letter and a number each.
class LineBuilder {
 public:
  explicit LineBuilder(std::string_view command) : text_(command) {}

  LineBuilder& word(char name, double value) {
    text_ += ' ';
    text_ += name;
    append_rounded(text_, value, kDecimals);
    return *this;
  }
  LineBuilder& at(double speed) { return word('F', speed * kSecondsPerMinute); }

  [[nodiscard]] Line line() const { return *Line::make(text_); }

 private:
  std::string text_;
};

Line plain(std::string_view text) {
  return *Line::make(text);
}

Line filament(double length, const ParkingPlace& place) {
  return LineBuilder("G1").word('E', length).at(place.retraction_speed).line();
}

bool retracts(const PrintState& state, const ParkingPlace& place) {
  return place.retraction > 0 && state.nozzle.value_or(0) >= kExtrudable;
}

double waiting_height(const PrintState& state, const ParkingPlace& place) {
  const double z = *state.position[2];
  const double highest = std::max(z, state.top.value_or(z)) + ParkingPlace::kLift;
  return std::max(z, std::min(highest, place.height_max));
}

// Last, because all moves before need modes of their own. Some firmware lets G90 and G91 speak for
// the extruder too.
void append_modes(std::vector<Line>& lines, const PrintState& state) {
  if (state.fan) lines.push_back(LineBuilder("M106").word('S', *state.fan).line());
  if (state.feed) lines.push_back(LineBuilder("G1").word('F', *state.feed).line());
  lines.push_back(plain(state.relative ? "G91" : "G90"));
  lines.push_back(plain(state.relative_extrusion ? "M83" : "M82"));
}

}  // namespace

std::vector<Line> heating_lines(const PrintState& state) {
  std::vector<Line> lines;
  const double nozzle = state.nozzle.value_or(0);
  const double bed = state.bed.value_or(0);
  if (nozzle > 0) lines.push_back(LineBuilder("M104").word('S', nozzle).line());
  if (bed > 0) lines.push_back(LineBuilder("M190").word('S', bed).line());
  if (nozzle > 0) lines.push_back(LineBuilder("M109").word('S', nozzle).line());
  return lines;
}

std::vector<Line> parking_lines(const PrintState& state, const ParkingPlace& place) {
  std::vector<Line> lines;
  if (!knows_place(state)) return lines;
  // Boards take the power off motors that stand still for two minutes, and places are lost.
  lines.push_back(plain("M84 S0"));
  lines.push_back(plain("G90"));
  lines.push_back(plain("M83"));
  if (retracts(state, place)) lines.push_back(filament(-place.retraction, place));
  lines.push_back(
      LineBuilder("G0").word('Z', waiting_height(state, place)).at(place.lift_speed).line());
  if (!state.renamed) {
    lines.push_back(
        LineBuilder("G0").word('X', place.x).word('Y', place.y).at(place.travel_speed).line());
  }
  lines.push_back(plain("M400"));
  return lines;
}

std::vector<Line> returning_lines(const PrintState& state, const ParkingPlace& place) {
  std::vector<Line> lines = heating_lines(state);
  if (!knows_place(state)) return lines;
  const auto& [x, y, z, e] = state.position;
  lines.push_back(plain("G90"));
  lines.push_back(plain("M83"));
  lines.push_back(LineBuilder("G0").word('X', *x).word('Y', *y).at(place.travel_speed).line());
  lines.push_back(LineBuilder("G0").word('Z', *z).at(place.lift_speed).line());
  if (retracts(state, place)) lines.push_back(filament(place.retraction, place));
  if (e) lines.push_back(LineBuilder("G92").word('E', *e).line());
  append_modes(lines, state);
  return lines;
}

std::vector<Line> recovering_lines(const PrintState& state, const ParkingPlace& place) {
  std::vector<Line> lines = heating_lines(state);
  const double z = *state.position[2];
  lines.push_back(plain("G90"));
  lines.push_back(plain("M83"));
  // Homing may lift the nozzle by itself, and counts from here.
  lines.push_back(LineBuilder("G92").word('Z', std::min(z, state.top.value_or(z))).line());
  lines.push_back(
      LineBuilder("G0").word('Z', waiting_height(state, place)).at(place.lift_speed).line());
  lines.push_back(plain("G28 X Y"));
  lines.push_back(
      LineBuilder("G0").word('X', place.x).word('Y', place.y).at(place.travel_speed).line());
  if (retracts(state, place)) {
    lines.push_back(LineBuilder("G1").word('E', kPrime).at(kPrimeSpeed).line());
    lines.push_back(filament(-place.retraction, place));
  }
  const std::vector<Line> back = returning_lines(state, place);
  lines.insert(lines.end(), back.begin(), back.end());
  return lines;
}

}  // namespace slipstick
