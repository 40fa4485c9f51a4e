#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "host/cancelled_object.h"
#include "host/layer_images.h"

namespace slipstick {

/// The images of layers without what was cancelled: in the layer that was named its island, above
/// it the islands that stand on nothing else. A pure function of layer and list, whoever asks when:
/// layers that were begun before something was cancelled never see that it was.
///
/// Threads: any thread may call anything at any time.
class KeptImages {
 public:
  using Image = ImageWindow::Image;

  /// Lists of `cancelled` that are asked about are beginnings of one list.
  KeptImages(LayerImages& images, const SliceGrid& grid, int layers)
      : images_(images), grid_(grid), layers_(layers) {}

  [[nodiscard]] Result<Image> image(int layer, std::span<const CancelledObject> cancelled);

  /// Drops what only layers below `layer` need; whoever asks for it again has all of it made again,
  /// from the layer that was named first.
  void forget_below(int layer);

 private:
  /// What is left out while a list of so many is in force, and the layers that are known of it.
  struct Chain {
    std::vector<CancelledObject> cancelled;
    std::map<int, Image> left_out;
  };

  [[nodiscard]] Chain& chain_of(std::span<const CancelledObject> cancelled);
  [[nodiscard]] Result<Image> left_out(Chain& chain, int layer);
  [[nodiscard]] Result<BitImage> step(const Chain& chain, int layer, const Image& below);

  LayerImages& images_;
  const SliceGrid grid_;
  const int layers_;
  std::mutex mutex_;  // protects the chains; each layer waits for the one below it anyway
  std::map<std::size_t, Chain> chains_;  // by how many are cancelled
};

}  // namespace slipstick
