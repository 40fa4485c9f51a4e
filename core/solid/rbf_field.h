#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/solid/rbf_function.h"
#include "core/solid/solid.h"

namespace slipstick {

/// \file
/// f of a blend of basis functions: the mean of their quadrics, weighted by Wendland's weights. The
/// functions are always summed in the order in which they are given, and those whose support does
/// not hold the point add nothing at all, so f does not depend on which of them were left out.

/// f(p), or nothing where no support holds p: there is outside.
[[nodiscard]] std::optional<double> rbf_value(std::span<const RbfFunction> functions, Vec3 p);

/// Whether f(p) <= 0: the sign of the weighted sum, without the quotient.
[[nodiscard]] bool rbf_inside(std::span<const RbfFunction> functions, Vec3 p);

/// Whether the support of `f` may hold a point of `box`; false is certain, rounding included.
[[nodiscard]] bool rbf_touches(const RbfFunction& f, const Box3& box);

/// What is known of all of `box`, which is certain as well. \pre `functions` are all that touch it.
///
/// A box in which all quadrics are positive is outside, and so is one in which the weighted sum is;
/// one in which that is negative and that one support holds altogether is inside. The bounds become
/// tight as the box shrinks.
[[nodiscard]] Cover rbf_cover(std::span<const RbfFunction> functions, const Box3& box);

/// The functions that touch `box`, in their order.
[[nodiscard]] std::vector<RbfFunction> rbf_narrowed(std::span<const RbfFunction> functions,
                                                    const Box3& box);

}  // namespace slipstick
