#include "core/gcode/write.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "core/gcode/resolvable.h"
#include "core/toolpath/flow.h"

using namespace slipstick;

namespace {

Bead line(Vec2 from, Vec2 to) {
  return {{from, to}, {0.45}, Role::kInfill, false};
}

double volume(const Moves& moves) {
  double sum = 0;
  for (const Piece& piece : moves.pieces) sum += piece.volume;
  return sum;
}

}  // namespace

TEST_CASE("A layer reads as it is printed") {
  PrintSettings settings;
  settings.material.seconds_per_layer_min = 0;
  const LayerToolpaths layer{1, 0.4, 0.2, {line({10, 10}, {20, 10}), line({20, 10.4}, {10, 10.4})}};

  const LayerProgram program = write_layer(layer, settings);

  CHECK(program.text ==
        ";LAYER:1\n"
        "M106 S255\n"
        "M104 S205\n"
        "G0 Z0.4 F600\n"
        "G0 X10 Y10 F7200\n"
        "G1 E1 F2100\n"
        "G1 X20 E0.33849 F3600\n"
        "G0 Y10.4 F7200\n"
        "G1 X10 E0.33849 F3600\n"
        "G1 E-1 F2100\n");
  const double wanted = filament_length(bead_area(0.45, 0.2), 20, 1.75);
  CHECK(program.filament_mm == Approx(wanted).margin(1e-5));
}

TEST_CASE("A small layer is slowed down to its least time") {
  PrintSettings settings;
  const LayerToolpaths layer{1, 0.4, 0.2, {line({10, 10}, {50, 10})}};
  settings.material.seconds_per_layer_min = 0;
  const double quick = write_layer(layer, settings).seconds;

  settings.material.seconds_per_layer_min = 4;
  const double slow = write_layer(layer, settings).seconds;

  CHECK(quick < 1);
  CHECK(slow > 2);
}

TEST_CASE("Moves too short for the printer are joined, and no plastic is lost") {
  Bead bead{{{0, 0}}, {0.4}, Role::kThinBead, false};
  for (int i = 1; i <= 100; ++i) bead.points.push_back({0.01 * i, 0.003 * i});

  const Moves moves = resolvable_moves(bead, 0.2);

  Vec2 at = moves.from;
  for (const Piece& piece : moves.pieces) {
    CHECK((std::abs(piece.to.x - at.x) >= kMoveMin || std::abs(piece.to.y - at.y) >= kMoveMin));
    at = piece.to;
  }
  CHECK(at == bead.points.back());
  const double path = length(bead.points.back() - bead.points.front());
  CHECK(volume(moves) == Approx(bead_area(0.4, 0.2) * path));
}

TEST_CASE("A bead below the least move is stretched, and its plastic stays") {
  const Bead speck{{{1, 1}, {1.02, 1}}, {0.1}, Role::kThinBead, false};

  const Moves moves = resolvable_moves(speck, 0.2);

  REQUIRE(moves.pieces.size() == 1);
  CHECK(moves.pieces[0].to.x - moves.from.x == Approx(kMoveMin));
  CHECK(volume(moves) == Approx(bead_area(0.1, 0.2) * 0.02));
}

TEST_CASE("The width of a bead follows from its area and back") {
  for (const double width : {0.05, 0.1, 0.2, 0.21, 0.45, 1.0}) {
    CHECK(bead_width(bead_area(width, 0.2), 0.2) == Approx(width));
  }
}

TEST_CASE("A layer on one with other settings says first what the printer would keep of them") {
  PrintSettings below;
  below.material.seconds_per_layer_min = 0;
  PrintSettings settings = below;
  settings.material.fan = 0.5;
  settings.material.nozzle_celsius = 220;
  settings.material.bed_celsius = 70;
  settings.material.retraction = 1.5;
  const LayerToolpaths layer{7, 1.6, 0.2, {line({10, 10}, {20, 10})}};

  const std::string text = write_layer(layer, settings, below).text;

  CHECK(text ==
        ";LAYER:7\n"
        "G1 E-0.5 F2100\n"
        "M106 S128\n"
        "M104 S220\n"
        "M140 S70\n"
        "G0 Z1.6 F600\n"
        "G0 X10 Y10 F7200\n"
        "G1 E1.5 F2100\n"
        "G1 X20 E0.33849 F3600\n"
        "G1 E-1.5 F2100\n");
}

TEST_CASE("A layer says nothing of settings that the one below had already") {
  const PrintSettings same;
  PrintSettings other = same;
  other.toolpath.infill_density = 0.9;
  const LayerToolpaths layer{7, 1.6, 0.2, {line({10, 10}, {20, 10})}};

  CHECK(write_layer(layer, same, other).text == write_layer(layer, same).text);
}

TEST_CASE("On the first layers only what holds there is said of other settings") {
  PrintSettings below;
  PrintSettings settings = below;
  settings.material.fan = 0.5;
  settings.material.nozzle_celsius = settings.material.first_layer_nozzle_celsius;
  settings.material.retraction = 0;
  const LayerToolpaths first{0, 0.2, 0.2, {}};
  const LayerToolpaths second{1, 0.4, 0.2, {}};

  CHECK(write_layer(first, settings, below).text == ";LAYER:0\nG1 E1 F2100\nG0 Z0.2 F600\n");
  CHECK(write_layer(second, settings, settings).text == ";LAYER:1\nM106 S128\nG0 Z0.4 F600\n");
}
