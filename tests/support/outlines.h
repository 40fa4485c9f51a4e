#pragma once

#include <vector>

#include "core/contour/audit.h"
#include "core/contour/outline.h"

namespace slipstick::test {

/// An outline as the audit takes it.
[[nodiscard]] inline std::vector<AuditLoop> audit_loops_of(const Outline& outline) {
  std::vector<AuditLoop> loops;
  for (const Outline::Loop& loop : outline.loops()) {
    loops.push_back({{}, loop.depth});
    for (const GridPoint p : loop.points) loops.back().points.push_back(outline.mm(p));
  }
  return loops;
}

}  // namespace slipstick::test
