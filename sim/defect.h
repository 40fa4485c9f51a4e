#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/vec.h"

namespace slipstick {

/// What may be wrong with a printed layer (judge.h says when).
enum class DefectKind : std::uint8_t {
  kIslandMissing,
  kIslandCut,
  kIslandsJoined,
  kHoleClosed,
  kHoleCut,
  kHolesJoined,
  kRimBare,
  kInTheAir,
  kInfillMissing,
  kLayerMissing,
};

/// One fault, where a person would look for it.
struct Defect {
  DefectKind kind{};
  Vec2 place;      ///< mm, on the bed.
  double mm2 = 0;  ///< How large: of kRimBare and what follows it.

  friend bool operator==(const Defect&, const Defect&) = default;
};

/// "islands joined"
[[nodiscard]] constexpr std::string_view describe(DefectKind kind) {
  switch (kind) {
    case DefectKind::kIslandMissing:
      return "island missing";
    case DefectKind::kIslandCut:
      return "island cut";
    case DefectKind::kIslandsJoined:
      return "islands joined";
    case DefectKind::kHoleClosed:
      return "hole closed";
    case DefectKind::kHoleCut:
      return "hole cut";
    case DefectKind::kHolesJoined:
      return "holes joined";
    case DefectKind::kRimBare:
      return "rim bare";
    case DefectKind::kInTheAir:
      return "laid in the air";
    case DefectKind::kInfillMissing:
      return "infill missing";
    case DefectKind::kLayerMissing:
      return "layer left out";
  }
  return "";
}

}  // namespace slipstick
