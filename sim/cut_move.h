#pragma once

#include "sim/axes.h"

namespace slipstick {

/// A straight move in pieces of one length, as machines need whose motors do not go straight with
/// it.
class CutMove {
 public:
  /// \pre `pieces` > 0.
  CutMove(const Axes& from, const Axes& to, int pieces) : from_(from), to_(to), pieces_(pieces) {}

  [[nodiscard]] int pieces() const { return pieces_; }
  /// Where piece `i` ends; the last exactly at the move's end. \pre 0 < i <= pieces().
  [[nodiscard]] Axes end_of(int i) const {
    return i == pieces_ ? to_ : from_ + (static_cast<double>(i) / pieces_) * (to_ - from_);
  }

 private:
  Axes from_;
  Axes to_;
  int pieces_;
};

}  // namespace slipstick
