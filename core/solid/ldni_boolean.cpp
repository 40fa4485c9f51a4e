#include "core/solid/ldni_boolean.h"

#include <utility>

namespace slipstick {
namespace {

bool joined(bool in_a, Boolean operation, bool in_b) {
  switch (operation) {
    case Boolean::kUnion:
      return in_a || in_b;
    case Boolean::kIntersection:
      return in_a && in_b;
    case Boolean::kDifference:
      return in_a && !in_b;
  }
  return false;
}

// A merge of two sorted lists; samples at one depth are taken together.
void append(LdniRays& out, std::span<const LdniSample> a, Boolean operation,
            std::span<const LdniSample> b) {
  std::size_t i = 0, k = 0;
  bool inside = false;
  while (i < a.size() || k < b.size()) {
    const bool from_a = k == b.size() || (i < a.size() && a[i].depth <= b[k].depth);
    const LdniSample next = from_a ? a[i] : b[k];
    while (i < a.size() && a[i].depth == next.depth) ++i;
    while (k < b.size() && b[k].depth == next.depth) ++k;
    const bool now = joined(i % 2 != 0, operation, k % 2 != 0);
    if (now != inside) out.samples.push_back(next);
    inside = now;
  }
  out.end_ray();
}

}  // namespace

Result<Ldni> merged(const Ldni& a, Boolean operation, const Ldni& b) {
  if (a.grid() != b.grid()) {
    return fail(ErrorCode::kInput,
                "the two are not on one grid of rays; make both with the same resolution, width "
                "and origin");
  }
  LdniAxes axes;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    for (std::size_t ray = 0; ray < a.grid().rays(); ++ray) {
      append(axes[axis], a.axes()[axis].of(ray), operation, b.axes()[axis].of(ray));
    }
  }
  return Ldni::of(a.grid(), std::move(axes));
}

}  // namespace slipstick
