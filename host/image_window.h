#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "core/base/result.h"
#include "core/image/bit_image.h"

namespace slipstick {

/// The bit images of the layers being worked on: each is made once, by whoever needs it first, and
/// shared by all that depends on it.
///
/// Threads: any thread may call anything at any time.
class ImageWindow {
 public:
  using Image = std::shared_ptr<const BitImage>;
  using Make = std::function<Result<Image>(int layer)>;

  /// Images of the layers `first` <= layer < `end`, made by `make`, which any thread may call.
  ImageWindow(const SliceGrid& grid, int first, int end, Make make)
      : nothing_(std::make_shared<const BitImage>(grid)),
        first_(first),
        end_(end),
        make_(std::move(make)) {}

  /// The image of `layer`; above and below those there are it is empty.
  [[nodiscard]] Result<Image> image(int layer);

  /// Drops what is below `layer`; whoever asks for it again has it made again.
  void forget_below(int layer);

 private:
  const Image nothing_;
  const int first_;
  const int end_;
  const Make make_;

  std::mutex mutex_;  // protects everything below; never held while making
  std::condition_variable ready_;
  using Slot = std::optional<Result<Image>>;  // nothing: being made
  std::map<int, std::shared_ptr<Slot>> images_;
};

}  // namespace slipstick
