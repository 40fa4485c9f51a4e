#pragma once

#include <memory>
#include <optional>

#include "core/contour/certify.h"
#include "core/contour/simplify.h"
#include "core/gcode/layer_program.h"
#include "core/image/bit_image.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// Seconds spent on each step, summed over threads.
struct StepSeconds {
  double sample = 0;
  double contour = 0;
  double place = 0;
  double simplify = 0;
  double verify = 0;
  double certify = 0;
  double toolpath = 0;
  double gcode = 0;

  StepSeconds& operator+=(const StepSeconds& other) {
    sample += other.sample;
    contour += other.contour;
    place += other.place;
    simplify += other.simplify;
    verify += other.verify;
    certify += other.certify;
    toolpath += other.toolpath;
    gcode += other.gcode;
    return *this;
  }
};

/// One finished layer and what is known of it.
struct SlicedLayer {
  int index = 0;
  double middle = 0;  ///< mm: height of the slicing plane.
  double top = 0;     ///< mm: upper face.
  std::shared_ptr<const BitImage> image;
  Simplified contours;
  std::size_t violations = 0;
  std::int64_t ambiguous_squares = 0;
  std::optional<LayerCertificate> certificate;  ///< Where asked for and possible.
  std::optional<LayerToolpaths> toolpaths;      ///< Where toolpaths were asked for.
  std::optional<LayerProgram> program;          ///< Likewise.
  StepSeconds seconds;
};

}  // namespace slipstick
