#include "host/place_contours.h"

#include "core/contour/place_laplacian.h"
#include "core/contour/place_roots.h"
#include "core/contour/place_smooth.h"

namespace slipstick {

void place_contours(ContourSet& contours, Placement placement, const Solid& solid, double z) {
  switch (placement) {
    case Placement::kRoots:
      return place_roots(contours, *solid.section(z));
    case Placement::kSliding:
      return place_sliding(contours);
    case Placement::kProjection:
      return place_projection(contours);
    case Placement::kLaplacian:
      return place_laplacian(contours);
    case Placement::kMidpoints:
      return;
  }
}

}  // namespace slipstick
