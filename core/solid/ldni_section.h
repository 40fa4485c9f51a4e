#pragma once

#include <memory>
#include <span>

#include "core/base/affine.h"
#include "core/solid/ldni_model.h"

namespace slipstick {

/// An LDNI cut at one height.
class LdniSection final : public Section {
 public:
  /// \param to_widths from the print's frame to widths of the grid, seen from its origin.
  LdniSection(std::shared_ptr<const LdniModel::Parts> parts, const Affine3& to_widths, double z);

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override;
  [[nodiscard]] Narrowed narrowed(const Box2& box) override;
  /// By squares, down to where all rays around one agree; only the nodes of the others are asked.
  bool paint(BitImage& image) override;
  bool evaluate(std::span<const double> xs, std::span<const double> ys,
                std::span<double> values) override;

 private:
  struct Range {
    LdniPoint low;
    LdniPoint high;
  };

  [[nodiscard]] LdniPoint at(double x, double y) const;
  [[nodiscard]] Range range_of(const Box2& box) const;
  [[nodiscard]] Cover cover(const Box2& box) const;

  std::shared_ptr<const LdniModel::Parts> parts_;
  Affine3 to_widths_;
  double z_;
  LdniSight sight_;
};

}  // namespace slipstick
