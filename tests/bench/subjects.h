#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/bit_image.h"
#include "core/job/placement.h"
#include "core/solid/solid.h"

namespace slipstick::bench {

/// \file
/// What targets and stages are measured on.

/// A plane of a solid over a lattice.
struct Subject {
  std::string name;
  std::shared_ptr<const Solid> solid;
  double z = 0;
  SliceGrid grid;
  bool smooth = false;  ///< No corners, f differentiable near the contour.
};

/// The solid of a Lua script, its lowest point at z = 0.
[[nodiscard]] std::shared_ptr<const Solid> lua_solid(std::string_view script);
/// The expression of a `.vm` file over [-1, 1], scaled to `size` mm a side.
[[nodiscard]] std::shared_ptr<const Solid> vm_solid(const std::string& path, double size);

/// `solid` at half its height, or at `z`, sampled every `sampling` mm.
[[nodiscard]] Subject subject(std::string name, std::shared_ptr<const Solid> solid, double sampling,
                              double z = -1);

/// Smooth shapes of about 1000 nodes a side: circle, blobs (random waves), gyroid sheet.
[[nodiscard]] std::vector<Subject> smooth_subjects();
/// Those, and shapes with corners: a turned square, a truss of struts, the example solids.
[[nodiscard]] std::vector<Subject> edge_subjects();
/// 3200 nodes a side, as a layer of the paper's Filigree: two of about as many sticks (26,000), and
/// a real model of five times as many.
[[nodiscard]] std::vector<Subject> filigree_layers();

/// The demo, `configs/solids/gyroid_sphere.lua`, in the middle of a bed of 200 mm.
[[nodiscard]] PlacedSolid example_on_bed();

/// The folder that SLIPSTICK_MODELS names, or nothing: rows that need real models are left out and
/// say so.
[[nodiscard]] std::string models_folder();

}  // namespace slipstick::bench
