#pragma once

#include <cstdint>
#include <string>

#include "core/base/vec.h"
#include "core/contour/simplify.h"

namespace slipstick {

/// \file
/// All settings of a print. settings_table.h names each with unit, range, default and help;
/// loaders,
/// `--set key=value` and the reference in docs/ go through that table.

/// Where the origin of a bed is.
enum class BedShape : std::uint8_t {
  kRectangle,  ///< At its front left corner.
  kRound,      ///< In its middle, as of deltas.
};

/// The machine.
struct PrinterSettings {
  std::string name = "Generic Marlin";
  Vec3 bed_size{220, 220, 250};  ///< Build volume.
  BedShape bed_shape = BedShape::kRectangle;
  double nozzle_diameter = 0.4;
  double filament_diameter = 1.75;
  double acceleration = 1000;  ///< mm/s², printing.
  double travel_acceleration = 1500;
  double speed_max = 200;   ///< mm/s, X and Y.
  double z_speed_max = 10;  ///< mm/s.
  int baud = 115200;
  int window = 0;           ///< Bytes of moves under way to the board; 0: one line at a time.
  std::string start_gcode;  ///< {bed_celsius} and {nozzle_celsius} are replaced.
  std::string end_gcode;
};

/// The filament.
struct MaterialSettings {
  std::string name = "PLA";
  double nozzle_celsius = 205;
  double first_layer_nozzle_celsius = 210;
  double bed_celsius = 60;
  double first_layer_bed_celsius = 60;
  double fan = 1;                    ///< 0 to 1, from the second layer on.
  double flow = 1;                   ///< Factor on all extrusion.
  double density = 1.24;             ///< g/cm³.
  double volume_speed_max = 12;      ///< mm³/s that the hot end melts.
  double retraction = 1;             ///< mm of filament; 0 is none.
  double retraction_speed = 35;      ///< mm/s.
  double seconds_per_layer_min = 8;  ///< Slower on small layers, so that they cool.
};

/// Where vertices sit on their sticks.
enum class Placement : std::uint8_t { kRoots, kSliding, kProjection, kLaplacian, kMidpoints };

/// How contours get fewer edges.
enum class Simplification : std::uint8_t { kFewest, kVsa, kGreedy, kNone };

/// What becomes of slices that cannot be proved right.
enum class Certification : std::uint8_t { kStrict, kReport, kOff };

/// How the solid becomes contours (paper, sections 3 to 5).
struct SlicingSettings {
  double layer_height = 0.2;
  double first_layer_height = 0.2;
  double sampling = 0.1;     ///< The paper's r'.
  int alpha = 10;            ///< The paper's clustering ratio: one proxy for so many edges.
  double tolerance = 0.025;  ///< mm: Fréchet bound between simplified and placed contours.
  Placement place = Placement::kRoots;
  Simplification simplify = Simplification::kFewest;
  Candidates candidates = Candidates::kThree;  ///< Of `kFewest`.
  Ambiguity ambiguity = Ambiguity::kSolid;
  double regularize = 0;  ///< mm: radius of the ball that opens and closes the solid; 0 is none.
  Certification certify = Certification::kReport;
};

/// How contours become toolpaths.
struct ToolpathSettings {
  double line_width = 0.45;
  double first_layer_line_width = 0.45;
  int perimeters = 2;
  int top_layers = 4;
  int bottom_layers = 3;
  double infill_density = 0.15;  ///< 0 to 1.
  double infill_angle = 45;      ///< Degrees on even layers; odd ones are turned by 90.
  double infill_overlap = 0.15;  ///< Of a line width, into the innermost perimeter.
  int skirt_loops = 1;
  double skirt_distance = 4;
  double perimeter_speed = 45;  ///< mm/s, this and the following.
  double outer_perimeter_speed = 30;
  double infill_speed = 60;
  double skin_speed = 45;
  double first_layer_speed = 20;
  double travel_speed = 120;
  double retract_travel_min = 1.5;  ///< mm: shorter travels do not retract.
  double seam_angle = 90;           ///< Degrees: where on the part seams gather; 90 is the rear.
};

struct PrintSettings {
  PrinterSettings printer;
  MaterialSettings material;
  SlicingSettings slicing;
  ToolpathSettings toolpath;
};

}  // namespace slipstick
