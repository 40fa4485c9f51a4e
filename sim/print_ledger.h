#pragma once

#include "core/base/result.h"
#include "core/contour/ledger.h"
#include "sim/pixel_image.h"

namespace slipstick {

/// The topology of a print from the pixels of its layers: cells are closed, so that layers whose
/// pixels share an edge or a corner hang together, as they do in the judge's layers.
class PrintLedger {
 public:
  /// For layers within `area`; what lies beyond is left out.
  /// \return kInput if `area` is more than 2^14 pixels wide or deep.
  [[nodiscard]] static Result<PrintLedger> over(const Box2& area, double pixel);

  /// The next layer, bottom to top. \pre Its pixels are of the size given.
  void add(const PixelImage& layer);

  [[nodiscard]] Topology topology() const { return ledger_.topology(); }

 private:
  PrintLedger(const PixelFrame& frame, const SliceGrid& grid)
      : frame_(frame), grid_(grid), ledger_(Ambiguity::kSolid) {}

  PixelFrame frame_;
  SliceGrid grid_;  ///< A node for each pixel of the frame, and a ring.
  StackLedger ledger_;
};

}  // namespace slipstick
