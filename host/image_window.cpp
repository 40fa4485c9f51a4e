#include "host/image_window.h"

namespace slipstick {

Result<ImageWindow::Image> ImageWindow::image(int layer) {
  if (layer < first_ || layer >= end_) return nothing_;
  std::unique_lock lock(mutex_);
  std::shared_ptr<Slot>& known = images_[layer];
  const bool is_first = !known;
  if (is_first) known = std::make_shared<Slot>();
  // It may be forgotten while it is waited for.
  const std::shared_ptr<Slot> slot = known;
  if (!is_first) {
    ready_.wait(lock, [&] { return slot->has_value(); });
    return **slot;
  }
  lock.unlock();
  Result<Image> result = make_(layer);
  lock.lock();
  *slot = result;
  ready_.notify_all();
  return result;
}

void ImageWindow::forget_below(int layer) {
  const std::lock_guard lock(mutex_);
  images_.erase(images_.begin(), images_.lower_bound(layer));
}

}  // namespace slipstick
