#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/image/bit_image.h"
#include "host/slicing_job.h"

namespace slipstick {

/// Which layer a figure shows: by number, by height, or else the one halfway up.
struct LayerChoice {
  std::optional<int> index;
  std::optional<double> height;  ///< mm above the bed.
};

/// One layer as it was sampled.
struct FigureLayer {
  int index = 0;
  double middle = 0;  ///< mm: height of the slicing plane.
  std::shared_ptr<const BitImage> image;
};

/// Samples one layer of `placed` as a print with these settings would.
/// \return kInput if there is no such layer, nothing is inside in it, or as SlicingJob.
[[nodiscard]] Result<FigureLayer> figure_layer(const PlacedSolid& placed, SlicingRequest request,
                                               const LayerChoice& choice);

/// Nodes of a lattice from `first_` to one before `end_`.
struct NodeWindow {
  int first_column = 0;
  int end_column = 0;
  int first_row = 0;
  int end_row = 0;

  [[nodiscard]] int columns() const { return end_column - first_column; }
  [[nodiscard]] int rows() const { return end_row - first_row; }
};

/// The nodes in `window` (mm). \return kInput if there are none.
[[nodiscard]] Result<NodeWindow> nodes_in(const Box2& window, const SliceGrid& grid);

/// All of a lattice, in mm.
[[nodiscard]] Box2 area_of(const SliceGrid& grid);

/// What is wrong with `path` where no picture can have that name.
[[nodiscard]] Error no_picture(const std::filesystem::path& path);

}  // namespace slipstick
