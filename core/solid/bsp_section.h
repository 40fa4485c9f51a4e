#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/solid/bsp_tree.h"
#include "core/solid/solid.h"

namespace slipstick {

/// A node in the print's frame.
struct PlacedBspNode {
  double x;
  double y;
  double z;
  double offset;
  BspChild front;
  BspChild back;
};
using PlacedBspNodes = std::vector<PlacedBspNode>;

/// The part of a tree below one child, cut at one height.
class BspSection final : public Section {
 public:
  BspSection(std::shared_ptr<const PlacedBspNodes> nodes, BspChild root, double z)
      : nodes_(std::move(nodes)), root_(root), z_(z) {}

  void classify(std::span<const double> xs, std::span<const double> ys,
                std::span<std::uint8_t> inside) override;
  [[nodiscard]] Narrowed narrowed(const Box2& box) override;
  void guess_changes(Vec2 from, Vec2 to, std::vector<double>& shares) override;
  bool paint(BitImage& image) override;

 private:
  // What is left of a way below a node, as shares of it.
  struct Piece {
    BspChild at;
    double begin;
    double end;
  };

  std::shared_ptr<const PlacedBspNodes> nodes_;
  BspChild root_;
  double z_;
  std::vector<Piece> pieces_;
};

}  // namespace slipstick
