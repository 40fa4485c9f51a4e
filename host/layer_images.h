#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "core/job/layers.h"
#include "core/region/regularize.h"
#include "core/solid/solid.h"
#include "host/image_window.h"

namespace slipstick {

/// The images of the layers as they are to be printed: sampled and, if wanted, opened and closed by
/// a ball, each step in a window of its own behind the one before it.
///
/// Threads: any thread may call anything at any time.
class LayerImages {
 public:
  using Image = ImageWindow::Image;

  /// \param regularize radius of the ball in mm, 0 for none. \pre `grid` has as much room around
  /// the solid.
  LayerImages(std::shared_ptr<const Solid> solid, const SliceGrid& grid, const LayerStack& stack,
              double regularize);

  /// The image of `layer`; above and below the stack it is empty.
  [[nodiscard]] Result<Image> image(int layer) { return windows_.back()->image(layer); }

  /// Drops what only layers below `layer` need; whoever asks for it again has it made again.
  void forget_below(int layer);

  /// Seconds spent sampling and regularizing so far, summed over threads.
  [[nodiscard]] double seconds() const { return seconds_.load(); }

 private:
  using Step = BitImage (*)(std::span<const BitImage* const>, const DiscreteBall&);

  [[nodiscard]] Result<Image> sampled(int layer);
  void add(Step step, int beyond);
  [[nodiscard]] Result<Image> stepped(ImageWindow& from, Step step, int layer);

  const std::shared_ptr<const Solid> solid_;
  const SliceGrid grid_;
  const LayerStack stack_;
  const DiscreteBall ball_;
  std::atomic<double> seconds_ = 0;
  std::vector<std::unique_ptr<ImageWindow>> windows_;  // each uses the one before it
};

}  // namespace slipstick
