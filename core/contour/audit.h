#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec.h"
#include "core/image/bit_image.h"

namespace slipstick {

/// \file
/// Checks contours from outside, knowing nothing of how they were made: `slipstick verify`, and
/// after every layer that is sliced. Shares no code with tracing, placement or simplification.
///
/// All predicates are exact: coordinates are taken as whole numbers of 2^-40 mm, of which
/// slipstick's are multiples, and products fit in 128 bits. Coordinates from elsewhere are rounded
/// to that (10^-12 mm).

/// A closed polygon in mm, the first point not repeated.
struct AuditLoop {
  std::vector<Vec2> points;
  int depth = 0;
};

/// One thing that is wrong.
struct Violation {
  enum class Kind : std::uint8_t {
    kCoordinate,   ///< Not a number, or beyond 10 m.
    kDegenerate,   ///< Fewer than 3 points, an edge of no length, or no area.
    kCrossing,     ///< Two edges that are not neighbours touch, or two neighbours overlap.
    kOrientation,  ///< Even depth not counter-clockwise or odd depth not clockwise.
    kNesting,      ///< Not inside as many loops as its depth says.
    kOffStick,     ///< A vertex that is not strictly between two neighbouring nodes of the lattice.
    kSample,       ///< A sample on the wrong side.
  };
  Kind kind = Kind::kCoordinate;
  Vec2 where;
};

/// "crossing", "wrong sample", …
[[nodiscard]] std::string describe(Violation::Kind kind);

/// At most so many violations are listed for a layer.
inline constexpr std::size_t kViolationsMax = 100;

/// Loops closed, simple, disjoint, nested and oriented as their depths say.
[[nodiscard]] std::vector<Violation> audit_loops(const std::vector<AuditLoop>& loops);

/// Every vertex strictly inside a lattice edge of `width` mm.
[[nodiscard]] std::vector<Violation> audit_sticks(const std::vector<AuditLoop>& loops,
                                                  double width);

/// Every sample of `image` on the side of the loops that the image says (even-odd rule).
[[nodiscard]] std::vector<Violation> audit_samples(const std::vector<AuditLoop>& loops,
                                                   const BitImage& image);

}  // namespace slipstick
