#include "host/layer_images.h"

#include <fmt/format.h>

#include "core/image/sample.h"
#include "host/stopwatch.h"

namespace slipstick {

LayerImages::LayerImages(std::shared_ptr<const Solid> solid, const SliceGrid& grid,
                         const LayerStack& stack, double regularize)
    : solid_(std::move(solid)), grid_(grid), stack_(stack), ball_{regularize, stack.thickness(1)} {
  windows_.push_back(std::make_unique<ImageWindow>(grid_, 0, stack_.count(),
                                                   [this](int layer) { return sampled(layer); }));
  if (regularize <= 0) return;
  add(eroded, 0);
  add(dilated, 0);
  // What grows beyond the stack must be there to shrink back from.
  add(dilated, ball_.reach());
  add(eroded, 0);
}

void LayerImages::forget_below(int layer) {
  for (auto window = windows_.rbegin(); window != windows_.rend(); ++window) {
    (*window)->forget_below(layer);
    layer -= ball_.reach();
  }
}

void LayerImages::add(Step step, int beyond) {
  ImageWindow& from = *windows_.back();
  windows_.push_back(std::make_unique<ImageWindow>(
      grid_, -beyond, stack_.count() + beyond,
      [this, &from, step](int layer) { return stepped(from, step, layer); }));
}

Result<LayerImages::Image> LayerImages::sampled(int layer) {
  Stopwatch watch;
  const auto section = solid_->section(stack_.middle(layer));
  Result<BitImage> image = sample(*section, grid_);
  seconds_ += watch.lap();
  if (!image) {
    return fail(
        image.error().within(fmt::format("layer {} at z={:.4g}", layer, stack_.middle(layer))));
  }
  return std::make_shared<const BitImage>(std::move(*image));
}

Result<LayerImages::Image> LayerImages::stepped(ImageWindow& from, Step step, int layer) {
  std::vector<Image> held;
  std::vector<const BitImage*> window;
  for (int k = layer - ball_.reach(); k <= layer + ball_.reach(); ++k) {
    auto image = from.image(k);
    if (!image) return fail(image.error());
    held.push_back(*image);
    window.push_back(held.back().get());
  }
  Stopwatch watch;
  auto result = std::make_shared<const BitImage>(step(window, ball_));
  seconds_ += watch.lap();
  return result;
}

}  // namespace slipstick
