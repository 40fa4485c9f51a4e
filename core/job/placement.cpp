#include "core/job/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slipstick {
namespace {

bool positive(double value) {
  return std::isfinite(value) && value > 0;
}

Result<void> check(const PlacementRequest& request) {
  if (!positive(request.scale) || !positive(request.unit)) {
    return fail(ErrorCode::kInput, fmt::format("scale {} is not a positive number", request.scale));
  }
  if (request.fit &&
      !(positive(request.fit->x) && positive(request.fit->y) && positive(request.fit->z))) {
    return fail(ErrorCode::kInput, "--fit wants three positive lengths in mm, such as 60,60,60");
  }
  if (!positive(length(request.direction))) {
    return fail(ErrorCode::kInput, "--direction must not be the zero vector");
  }
  return {};
}

constexpr std::string_view kEmpty =
    "the solid is empty: f > 0 everywhere within its bounds; check the model, or --bounds for a "
    ".vm file";

double fit_factor(const Vec3& size, const Vec3& room) {
  return std::min({room.x / size.x, room.y / size.y, room.z / size.z});
}

bool fits_bed(const Box3& bounds, const PrinterSettings& printer) {
  const Vec3 size = printer.bed_size;
  if (printer.bed_shape == BedShape::kRound) {
    const double x = std::max(-bounds.low.x, bounds.high.x);
    const double y = std::max(-bounds.low.y, bounds.high.y);
    return 2 * std::hypot(x, y) <= std::min(size.x, size.y);
  }
  return bounds.low.x >= 0 && bounds.low.y >= 0 && bounds.high.x <= size.x &&
         bounds.high.y <= size.y;
}

}  // namespace

Result<PlacedSolid> place_on_bed(const Model& model, const PlacementRequest& request,
                                 Vec2 bed_centre) {
  if (const auto ok = check(request); !ok) return fail(ok.error());
  const double size = request.unit * request.scale;
  Affine3 map = composed(rotation_degrees(request.rotate),
                         composed(rotation_to_z(request.direction), scaling({size, size, size})));
  Box3 bounds = model.bounds_under(map);
  if (bounds.empty()) return fail(ErrorCode::kInput, std::string(kEmpty));
  if (request.fit) {
    const double factor = fit_factor(bounds.size(), *request.fit);
    if (!positive(factor))
      return fail(ErrorCode::kInput, "the model is flat; --fit cannot scale it");
    map = composed(scaling({factor, factor, factor}), map);
    bounds = model.bounds_under(map);
  }
  const Vec3 centre = bounds.centre();
  const Vec3 move{bed_centre.x - centre.x, bed_centre.y - centre.y, -bounds.low.z};
  map = composed(translation(move), map);
  bounds = {bounds.low + move, bounds.high + move};
  return PlacedSolid{model.placed(map), bounds, inverse(map)};
}

Vec2 bed_centre(const PrinterSettings& printer) {
  if (printer.bed_shape == BedShape::kRound) return {0, 0};
  return {printer.bed_size.x / 2, printer.bed_size.y / 2};
}

Result<void> check_build_volume(const Box3& bounds, const PrinterSettings& printer) {
  const Vec3 s = bounds.size();
  const Vec3 size = printer.bed_size;
  if (fits_bed(bounds, printer) && bounds.high.z <= size.z) return {};
  return fail(
      ErrorCode::kInput,
      fmt::format("the model is {:.4g} x {:.4g} x {:.4g} mm and does not fit the build volume "
                  "of {:.4g} x {:.4g} x {:.4g} mm{}; use --fit or --scale",
                  s.x, s.y, s.z, size.x, size.y, size.z,
                  printer.bed_shape == BedShape::kRound ? ", which is round" : ""));
}

}  // namespace slipstick
