#include "core/toolpath/infill.h"

#include <cmath>
#include <limits>

#include "core/region/level.h"
#include "core/region/morphology.h"
#include "core/toolpath/raster.h"

namespace slipstick {
namespace {

// Skins reach so many line widths beyond where they are needed, to hold on to something.
constexpr double kSkinReach = 2;
// Pieces shorter than this (mm) would be drops.
constexpr double kPieceMin = 0.05;

class Infill {
 public:
  Infill(const LayerInput& input, const DistanceField& depth, const LineMeasures& lines,
         const PrintSettings& settings)
      : input_(input), depth_(depth), lines_(lines), settings_(settings) {}

  std::vector<Bead> run() {
    const BitImage inner = depth_.at_least(lines_.infill_edge());
    if (!inner.any()) return {};
    const BitImage skin = skin_of(inner);
    add(raster(polygons(skin), {lines_.spacing, angle()}), Role::kSkin);
    const RasterOptions sparse{sparse_spacing(), angle()};
    add(raster(polygons(inner - skin), sparse), Role::kInfill);
    add(connecting_lines(polygons(inner), sparse), Role::kInfill);
    return std::move(beads_);
  }

 private:
  BitImage skin_of(const BitImage& inner) const {
    if (settings_.toolpath.infill_density >= 1) return inner;
    const BitImage bare = (inner - input_.above) | (inner - input_.below);
    if (!bare.any()) return bare;
    const int reach =
        static_cast<int>(std::lround(kSkinReach * lines_.width / input_.image.grid().width()));
    return dilated(bare, reach) & inner;
  }

  std::vector<std::vector<Vec2>> polygons(const BitImage& part) const {
    return polygons_of(level_outline(part, depth_, lines_.infill_edge(),
                                     settings_.slicing.tolerance, settings_.slicing.ambiguity));
  }

  double sparse_spacing() const {
    const double density = settings_.toolpath.infill_density;
    return density > 0 ? lines_.spacing / density : std::numeric_limits<double>::infinity();
  }

  double angle() const {
    return settings_.toolpath.infill_angle + (input_.layer % 2 == 0 ? 0 : 90);
  }

  void add(const std::vector<RasterLine>& pieces, Role role) {
    for (const RasterLine& piece : pieces) {
      if (length(piece.to - piece.from) < kPieceMin) continue;
      beads_.push_back({{piece.from, piece.to}, {lines_.width}, role, false});
    }
  }

  const LayerInput& input_;
  const DistanceField& depth_;
  const LineMeasures& lines_;
  const PrintSettings& settings_;
  std::vector<Bead> beads_;
};

}  // namespace

std::vector<Bead> infill_beads(const LayerInput& input, const DistanceField& depth,
                               const LineMeasures& lines, const PrintSettings& settings) {
  return Infill(input, depth, lines, settings).run();
}

}  // namespace slipstick
