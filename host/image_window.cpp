#include "host/image_window.h"

namespace slipstick {

Result<ImageWindow::Image> ImageWindow::image(int layer) {
  if (layer < first_ || layer >= end_) return nothing_;
  std::unique_lock lock(mutex_);
  const auto [at, is_first] = images_.try_emplace(layer);
  if (!is_first) {
    ready_.wait(lock, [&, slot = at] { return slot->second.has_value(); });
    return *at->second;
  }
  lock.unlock();
  Result<Image> result = make_(layer);
  lock.lock();
  at->second = result;
  ready_.notify_all();
  return result;
}

void ImageWindow::forget_below(int layer) {
  const std::lock_guard lock(mutex_);
  images_.erase(images_.begin(), images_.lower_bound(layer));
}

}  // namespace slipstick
