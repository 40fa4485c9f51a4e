#pragma once

#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/image/bit_image.h"

namespace slipstick::test {

/// A grid of 0.125 mm with `columns` × `rows` nodes within a margin of two.
[[nodiscard]] SliceGrid small_grid(int columns, int rows);

/// An image from a picture, top row first, `#` inside, the margin added.
[[nodiscard]] BitImage image_of(const std::vector<std::string>& picture);

/// The picture of an image without its margin.
[[nodiscard]] std::vector<std::string> picture_of(const BitImage& image);

/// Independent samples, a share of `density` inside.
[[nodiscard]] BitImage noise(Rng& rng, int columns, int rows, double density);

/// One of many families of regular images (discs, rings, combs, checkerboards, staircases, spirals,
/// one-node lines, …) of random size and place.
[[nodiscard]] BitImage structured(Rng& rng);

}  // namespace slipstick::test
