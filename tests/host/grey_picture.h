#pragma once

#include <cairo.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>

#include "core/base/check.h"

namespace slipstick::test {

/// A `.png` as it was written, read back.
class GreyPicture {
 public:
  /// \pre The file is a picture.
  explicit GreyPicture(const std::filesystem::path& path)
      : surface_(cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy) {
    SLIPSTICK_CHECK(cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS);
  }

  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_.get()); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_.get()); }

  /// Whether the pixel's blue is nearer to none than to all; y downwards.
  [[nodiscard]] bool dark(int x, int y) const {
    const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface_.get());
    std::uint32_t pixel = 0;
    std::memcpy(&pixel,
                cairo_image_surface_get_data(surface_.get()) + y * stride + 4 * std::ptrdiff_t{x},
                sizeof pixel);
    return (pixel & 0xFFu) < 128;
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
};

}  // namespace slipstick::test
