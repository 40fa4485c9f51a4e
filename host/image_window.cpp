#include "host/image_window.h"

#include <fmt/format.h>

#include "core/image/sample.h"
#include "host/stopwatch.h"

namespace slipstick {

Result<ImageWindow::Image> ImageWindow::image(int layer) {
  if (layer < 0 || layer >= stack_.count()) return std::make_shared<const BitImage>(grid_);
  std::unique_lock lock(mutex_);
  const auto [at, is_first] = images_.try_emplace(layer);
  if (!is_first) {
    ready_.wait(lock, [&, slot = at] { return slot->second.has_value(); });
    return *at->second;
  }
  lock.unlock();
  Stopwatch watch;
  Result<Image> result = sampled(layer);
  lock.lock();
  sampling_seconds_ += watch.lap();
  at->second = result;
  ready_.notify_all();
  return result;
}

void ImageWindow::forget_below(int layer) {
  const std::lock_guard lock(mutex_);
  images_.erase(images_.begin(), images_.lower_bound(layer));
}

double ImageWindow::sampling_seconds() const {
  const std::lock_guard lock(mutex_);
  return sampling_seconds_;
}

Result<ImageWindow::Image> ImageWindow::sampled(int layer) {
  const auto section = solid_->section(stack_.middle(layer));
  Result<BitImage> image = sample(*section, grid_);
  if (!image) {
    return fail(
        image.error().within(fmt::format("layer {} at z={:.4g}", layer, stack_.middle(layer))));
  }
  return std::make_shared<const BitImage>(std::move(*image));
}

}  // namespace slipstick
