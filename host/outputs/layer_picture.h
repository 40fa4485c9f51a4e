#pragma once

#include <cairo.h>

#include "core/base/box.h"
#include "core/contour/outline.h"
#include "core/toolpath/path.h"

namespace slipstick {

/// A layer as a picture: contours filled, beads as wide as they are laid, coloured by role.
struct LayerPicture {
  int index = 0;
  double middle = 0;  ///< mm
  Outline outline;
  std::vector<Bead> beads;
};

/// A rectangle of the picture, in its units, with y downwards.
struct Frame {
  double x = 0;
  double y = 0;
  double size = 0;  ///< Side of a square.
};

/// Draws `picture` into `frame`, so that `area` (mm) fills it, with a caption.
void draw_layer(cairo_t* cairo, const LayerPicture& picture, const Box2& area, const Frame& frame);

}  // namespace slipstick
