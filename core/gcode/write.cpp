#include "core/gcode/write.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/gcode/move_writer.h"
#include "core/gcode/resolvable.h"
#include "core/toolpath/flow.h"

namespace slipstick {
namespace {

constexpr double kSpeedMin = 5;  // mm/s: slower than this a nozzle only cooks what it lies on
constexpr double kFullFan = 255;

double wanted_speed(Role role, const ToolpathSettings& t) {
  switch (role) {
    case Role::kSkirt:
      return t.first_layer_speed;
    case Role::kOuterPerimeter:
    case Role::kThinBead:
      return t.outer_perimeter_speed;
    case Role::kInnerPerimeter:
      return t.perimeter_speed;
    case Role::kSkin:
      return t.skin_speed;
    case Role::kInfill:
      return t.infill_speed;
  }
  return t.first_layer_speed;
}

// What a layer needs to be written; `slowdown` multiplies the speeds of its beads.
struct Pace {
  double slowdown = 1;
};

class LayerWriter {
 public:
  LayerWriter(const LayerToolpaths& layer, const PrintSettings& settings,
              const PrintSettings& below)
      : layer_(layer), settings_(settings), below_(below), moves_(settings) {}

  LayerProgram run(Pace pace) {
    moves_.line(fmt::format(";LAYER:{}", layer_.layer));
    moves_.retracted_by(below_.material.retraction);
    if (layer_.layer == 1) leave_first_layer();
    if (layer_.layer > 1) leave_layer_below();
    moves_.height(layer_.top);
    for (const Bead& bead : layer_.beads) lay(bead, pace);
    moves_.retract();
    return {layer_.layer, moves_.take_text(), moves_.seconds(), moves_.filament_mm()};
  }

 private:
  void leave_first_layer() {
    const MaterialSettings& m = settings_.material;
    say_fan();
    if (m.nozzle_celsius != m.first_layer_nozzle_celsius) say_nozzle();
    if (m.bed_celsius != m.first_layer_bed_celsius) say_bed();
  }

  // What was set by hand meanwhile stays, unless it is this that changes.
  void leave_layer_below() {
    const MaterialSettings& m = settings_.material;
    const MaterialSettings& below = below_.material;
    if (m.fan != below.fan) say_fan();
    if (m.nozzle_celsius != below.nozzle_celsius) say_nozzle();
    if (m.bed_celsius != below.bed_celsius) say_bed();
  }

  void say_fan() { moves_.line(fmt::format("M106 S{:.0f}", settings_.material.fan * kFullFan)); }
  void say_nozzle() { moves_.line(fmt::format("M104 S{:.0f}", settings_.material.nozzle_celsius)); }
  void say_bed() { moves_.line(fmt::format("M140 S{:.0f}", settings_.material.bed_celsius)); }

  void lay(const Bead& bead, Pace pace) {
    const Moves moves = resolvable_moves(bead, layer_.height);
    moves_.travel(moves.from);
    Vec2 at = moves.from;
    for (const Piece& piece : moves.pieces) {
      const double path = length(piece.to - at);
      const double area = piece.volume / path * settings_.material.flow;
      moves_.extrude(piece.to, filament_length(area, path, settings_.printer.filament_diameter),
                     speed(bead.role, area, pace));
      at = piece.to;
    }
  }

  [[nodiscard]] double speed(Role role, double area, Pace pace) const {
    double speed = wanted_speed(role, settings_.toolpath);
    if (layer_.layer == 0) speed = std::min(speed, settings_.toolpath.first_layer_speed);
    speed =
        std::min({speed, settings_.printer.speed_max, settings_.material.volume_speed_max / area});
    return std::max(speed * pace.slowdown, std::min(speed, kSpeedMin));
  }

  const LayerToolpaths& layer_;
  const PrintSettings& settings_;
  const PrintSettings& below_;
  MoveWriter moves_;
};

std::string filled_in(std::string text, const MaterialSettings& m) {
  const auto replace = [&text](std::string_view name, double celsius) {
    const std::string value = fmt::format("{:.0f}", celsius);
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += value.size()) {
      text.replace(at, name.size(), value);
    }
  };
  replace("{bed_celsius}", m.first_layer_bed_celsius);
  replace("{nozzle_celsius}", m.first_layer_nozzle_celsius);
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

}  // namespace

LayerProgram write_layer(const LayerToolpaths& layer, const PrintSettings& settings) {
  return write_layer(layer, settings, settings);
}

LayerProgram write_layer(const LayerToolpaths& layer, const PrintSettings& settings,
                         const PrintSettings& below) {
  LayerProgram program = LayerWriter(layer, settings, below).run({});
  const double least = settings.material.seconds_per_layer_min;
  if (layer.beads.empty() || program.seconds >= least) return program;
  return LayerWriter(layer, settings, below).run({program.seconds / least});
}

LayerProgram write_start(const PrintSettings& settings) {
  std::string text = filled_in(settings.printer.start_gcode, settings.material);
  // Layers begin by undoing the retraction that the one before ended with.
  text += "G90\nM83\n";
  if (settings.material.retraction > 0) {
    text += fmt::format("G1 E-{:.5f} F{:.0f}\n", settings.material.retraction,
                        settings.material.retraction_speed * 60);
  }
  return {-1, std::move(text), 0, 0};
}

LayerProgram write_end(const PrintSettings& settings) {
  return {-1, filled_in(settings.printer.end_gcode, settings.material), 0, 0};
}

}  // namespace slipstick
