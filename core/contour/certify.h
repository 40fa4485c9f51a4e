#pragma once

#include <cstdint>
#include <vector>

#include "core/base/box.h"
#include "core/image/bit_image.h"
#include "core/solid/field.h"

namespace slipstick {

/// \file
/// What can be proved of a slice, and of what lies between it and the next, from bounds of f and
/// its gradient (Plantinga and Vegter 2004; Lin and Yap 2009). Of f as a real function: it says
/// nothing of nodes where f is smaller than the rounding error of its evaluation.

/// A place between two slices where a section may change its topology: the surface may have a
/// horizontal tangent plane.
struct SlabEvent {
  enum class Kind : std::uint8_t {
    /// Every vertical line through it meets the surface at most once between the two planes, or is
    /// tangent to it: whatever is there is cut by the plane below or by the one above at this very
    /// place. A top, a bottom, a terrace, a saddle.
    kStep,
    /// A vertical line may meet the surface twice between the planes: an island, a membrane, a gap
    /// or a neck thinner than the layer may lie there and be in neither slice.
    kHidden,
  };
  Kind kind = Kind::kStep;
  Box3 box;  ///< mm; whole squares of the lattice.
};

struct LayerCertificate {
  std::int64_t cells = 0;        ///< Squares of the lattice that the contour passes.
  std::int64_t uncertified = 0;  ///< Squares that f = 0 may pass in an unproved way.
  /// Middles of the first few of them, mm.
  std::vector<Vec2> uncertified_at;
  /// Neighbouring squares of one kind are one event.
  std::vector<SlabEvent> events;
  /// False: there was more to look at than the effort allows; nothing is known of the rest.
  bool complete = true;

  /// Adds what was found elsewhere.
  LayerCertificate& operator+=(const LayerCertificate& other);

  [[nodiscard]] std::int64_t hidden() const;
  /// Nothing is left open: the slice is isotopic to the solid's section at z, and whatever topology
  /// there is up to the next plane shows in the two slices.
  [[nodiscard]] bool proved() const { return complete && uncertified == 0 && hidden() == 0; }
};

/// How many boxes may be looked at: as many as the slice's size warrants, so that a layer of a hard
/// expression does not take seconds, or as many as it takes, up to `kCertifyBoxesMax`.
enum class CertifyEffort : std::uint8_t { kQuick, kThorough };

/// Looks at the slice at `z`, of which `image` is the samples, and at the slab from there to
/// `above`.
///
/// A square is certified if, in its box at z, f has no zero or fx has none or fy has none: then
/// the curve in it is a graph, and all squares of such boxes together make the slice isotopic to
/// the section. One box may certify many squares; one that it leaves open is looked at in parts
/// (`judge_curve`). A slab box holds no event if f has no zero in it
/// or the derivative in one of four horizontal directions has none: then the surface has no
/// horizontal tangent plane there. If no box of a slab fails, all sections in it are isotopic.
/// Failing columns, one square wide, are split in eight up to `kEventSplits` times.
///
/// \pre z <= above. The solid lies within the image's window.
[[nodiscard]] LayerCertificate certify_layer(Field& field, const BitImage& image, double z,
                                             double above,
                                             CertifyEffort effort = CertifyEffort::kThorough);

/// The slab alone, for those below the first slice and above the last.
[[nodiscard]] LayerCertificate certify_slab(Field& field, const SliceGrid& grid, double z,
                                            double above);

inline constexpr std::int64_t kCertifyBoxesMax = 200'000;
inline constexpr std::int64_t kQuickBoxesPerSquare = 4;  ///< That the contour passes.
inline constexpr std::int64_t kQuickBoxesMin = 1'024;
inline constexpr int kEventSplits = 3;
inline constexpr std::size_t kPlacesMax = 8;

}  // namespace slipstick
