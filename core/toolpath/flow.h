#pragma once

namespace slipstick {

/// \file
/// Cross-sections of beads: a rectangle with round ends where the bead is wider than the layer is
/// high, (w − l)·l + π·l²/4, and a circle where it is narrower. Slicer and simulator share the
/// model.

/// mm² of a bead `width` wide in a layer `height` high. \pre Both > 0.
[[nodiscard]] double bead_area(double width, double height);

/// The width of a bead of `area` mm²: the inverse of `bead_area`. \pre Both > 0.
[[nodiscard]] double bead_width(double area, double height);

/// Distance between neighbouring lines at which beads of `width` leave no gap:
/// w − l·(1 − π/4), or w where the bead is narrower than the layer. \pre Both > 0.
[[nodiscard]] double bead_spacing(double width, double height);

/// mm of filament for `length` mm of a bead of `area`. \pre `filament_diameter` > 0.
[[nodiscard]] double filament_length(double area, double length, double filament_diameter);

}  // namespace slipstick
