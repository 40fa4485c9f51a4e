#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>

#include "core/image/bit_image.h"
#include "core/job/layers.h"
#include "core/solid/solid.h"

namespace slipstick {

/// The bit images of the layers being worked on: each is sampled once, by whoever needs it first,
/// and shared by the layers whose skins depend on it.
///
/// Threads: any thread may call anything at any time.
class ImageWindow {
 public:
  using Image = std::shared_ptr<const BitImage>;

  ImageWindow(std::shared_ptr<const Solid> solid, const SliceGrid& grid, const LayerStack& stack)
      : solid_(std::move(solid)), grid_(grid), stack_(stack) {}

  /// The image of `layer`; above and below the stack it is empty.
  [[nodiscard]] Result<Image> image(int layer);

  /// Drops what is below `layer`. The caller promises that nobody asks for it again.
  void forget_below(int layer);

  /// Seconds spent sampling so far, summed over threads.
  [[nodiscard]] double sampling_seconds() const;

 private:
  [[nodiscard]] Result<Image> sampled(int layer);

  const std::shared_ptr<const Solid> solid_;
  const SliceGrid grid_;
  const LayerStack stack_;

  mutable std::mutex mutex_;  // protects everything below; never held while sampling
  std::condition_variable ready_;
  std::map<int, std::optional<Result<Image>>> images_;  // nothing: being sampled
  double sampling_seconds_ = 0;
};

}  // namespace slipstick
