#include "sim/print_ledger.h"

#include "sim/pixel_runs.h"

namespace slipstick {

Result<PrintLedger> PrintLedger::over(const Box2& area, double pixel) {
  const PixelFrame frame = PixelFrame::over(area, pixel);
  // Only how many nodes there are matters: topology has no measure.
  const auto grid = SliceGrid::over({{0, 0}, {frame.columns * pixel, frame.rows * pixel}}, pixel);
  if (!grid) return fail(grid.error());
  return PrintLedger(frame, *grid);
}

void PrintLedger::add(const PixelImage& layer) {
  const PixelImage pixels = layer.within(frame_);
  BitImage image(grid_);
  for (int r = 0; r < frame_.rows; ++r) {
    for_set_runs(pixels.row(r), frame_.columns,
                 [&](int begin, int end) { image.fill(begin + 1, r + 1, end - begin, 1); });
  }
  ledger_.add(image);
}

}  // namespace slipstick
