#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/vec.h"

namespace slipstick {

/// \file
/// Tables 1 to 3 of Huang, Wang and Chen, "Intersection-free and topologically faithful slicing of
/// implicit solid" (section 6), and which model stands for each of theirs here.

/// What a table of theirs is about.
enum class PaperTable : std::uint8_t {
  kLdni = 1,  ///< Layered depth-normal images.
  kBsp = 2,
  kRbf = 3,
};

/// A row, in their units: inches and minutes.
struct PaperRow {
  PaperTable table = PaperTable::kLdni;
  std::string_view name;
  Vec3 size;            ///< in
  double sampling = 0;  ///< in: r'
  double minutes = 0;
  double sampling_minutes = 0;
  double distortion = 0;  ///< in³: the largest regional distortion, D'.
  double edges_before = 0;
  double edges_after = 0;
  int layers = 0;

  std::string_view stand_in;      ///< A file; empty: the script `kTrussScript`.
  bool lies_on_its_back = false;  ///< y is up in the file.

  int rays = 0;          ///< Of the images, a side.
  double ray_width = 0;  ///< in: between them.
};

/// In the order of the paper.
[[nodiscard]] std::span<const PaperRow> paper_rows();

/// Of all their tests.
inline constexpr double kPaperLayerHeight = 0.01;            ///< in
inline constexpr double kInch = 25.4;                        ///< mm
inline constexpr double kCubicInch = kInch * kInch * kInch;  ///< mm³

/// A cubic truss with diagonals, 2.40 x 5.82 x 2.54 in: nobody has published theirs.
[[nodiscard]] std::string_view truss_script();

}  // namespace slipstick
