#include "core/toolpath/flow.h"

#include <cmath>
#include <numbers>

namespace slipstick {

using std::numbers::pi;

double bead_area(double width, double height) {
  if (width <= height) return pi * width * width / 4;
  return (width - height) * height + pi * height * height / 4;
}

double bead_width(double area, double height) {
  const double round = pi * height * height / 4;
  if (area <= round) return std::sqrt(4 * area / pi);
  return (area - round) / height + height;
}

double bead_spacing(double width, double height) {
  if (width <= height) return width;
  return width - height * (1 - pi / 4);
}

double filament_length(double area, double length, double filament_diameter) {
  return area * length / (pi * filament_diameter * filament_diameter / 4);
}

}  // namespace slipstick
