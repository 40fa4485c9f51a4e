#pragma once

#include <memory>

#include "core/expr/gradient.h"

namespace slipstick {

/// The function of a solid seen box by box: what certificates are made from.
/// Threads: used by one thread at a time; it may hold scratch memory.
class Field {
 public:
  Field() = default;
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;
  virtual ~Field() = default;

  [[nodiscard]] virtual GradientRange over(const Box3& box) = 0;

  /// The same within `box` for less work; null if there is nothing to gain.
  [[nodiscard]] virtual std::unique_ptr<Field> narrowed(const Box3& box) = 0;
};

}  // namespace slipstick
