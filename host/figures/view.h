#pragma once

#include <cairo.h>

#include <span>
#include <string>

#include "core/base/box.h"
#include "core/contour/cluster.h"
#include "host/outputs/layer_picture.h"

namespace slipstick {

/// A colour, each part 0 to 1.
struct Ink {
  double red = 0;
  double green = 0;
  double blue = 0;
};

/// Room for the words above a panel.
inline constexpr double kCaptionHeight = 22;

/// A panel of a figure: a square that shows `area` (mm) evenly scaled, the middle in the middle.
/// Everything but the caption is clipped to it; widths are in units of the picture.
class View {
 public:
  /// \param frame where; its uppermost `kCaptionHeight` are added above it.
  View(cairo_t* cairo, const Box2& area, const Frame& frame);

  void caption(const std::string& words) const;
  /// A thin line round it.
  void border() const;

  /// Strokes `points`, leaving out edges that cannot be seen.
  void stroke(std::span<const Vec2> points, Connection connection, Ink ink, double width) const;
  void dots(std::span<const Vec2> points, Ink ink, double diameter) const;

  /// Units of the picture a millimetre.
  [[nodiscard]] double scale() const { return scale_; }

 private:
  [[nodiscard]] Vec2 at(Vec2 mm) const;
  [[nodiscard]] bool seen(Vec2 a, Vec2 b) const;
  void clip() const;

  cairo_t* cairo_;
  Frame frame_;
  Vec2 centre_;
  double scale_;
  Box2 seen_;
};

}  // namespace slipstick
