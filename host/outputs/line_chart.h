#pragma once

#include <cairo.h>

#include <string>
#include <vector>

#include "core/base/vec.h"

namespace slipstick {

/// A quantity over another, both >= 0, as a line with a mark at each point.
struct LineChart {
  std::string quantity;  ///< "edges after simplification"
  std::string unit;      ///< "in³"; empty for a number of things.
  std::string over;      ///< What goes to the right.
  std::vector<Vec2> points;
};

/// Where a chart lies in the picture, its words included.
struct ChartFrame {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// Draws axes from 0 with ticks, the power of a thousand of the upright one in its title, and the
/// line.
void draw_line_chart(cairo_t* cairo, const LineChart& chart, const ChartFrame& frame);

}  // namespace slipstick
