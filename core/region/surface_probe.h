#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/region/facing.h"
#include "core/solid/solid.h"

namespace slipstick {

/// The axis of the print's frame, of a section's two, along which a line runs.
enum class SectionAxis : std::uint8_t { kX, kY };

/// A part of a line along an axis, the surface somewhere in it: exactly one of its ends is inside.
struct SurfaceBracket {
  SectionAxis axis = SectionAxis::kX;
  double line = 0;  ///< The other coordinate, mm.
  double from = 0;
  double to = 0;  ///< > from
  bool from_inside = false;
};

/// Finds points of a surface and its normals there by asking on which side points are, so of any
/// solid: the same surface is looked for on four parallel lines nearby.
/// Threads: one at a time.
class SurfaceProbe {
 public:
  /// \param step mm; normals are taken over a fraction of it, to within a degree or two.
  SurfaceProbe(const Solid& solid, double z, double step);

  /// For each bracket the point of the surface and its normal in the print's frame, pointing along
  /// the bracket from `from` to `to`; nothing where the surface has an edge, or is inclined to the
  /// axis by more than about 68 degrees.
  [[nodiscard]] std::vector<std::optional<SurfacePoint>> probe(
      std::span<const SurfaceBracket> brackets);

  /// Whether the two sides of what a chord along `axis` runs through, with normals along it, are
  /// those of a wedge: going on to where it is thicker it grows on as they are inclined, and the
  /// other way it gets thinner. So it has no thickness of its own there, unlike a rod or a neck.
  [[nodiscard]] bool is_wedge(SectionAxis axis, const SurfacePoint& first,
                              const SurfacePoint& last);

 private:
  using Places = std::vector<std::optional<double>>;

  Places beside(Section& section, std::span<const SurfaceBracket> brackets, const Places& places,
                double aside);

  double z_;
  double step_;
  double aside_;  // mm from a line to those beside it
  std::unique_ptr<Section> below_;
  std::unique_ptr<Section> section_;
  std::unique_ptr<Section> above_;
};

}  // namespace slipstick
