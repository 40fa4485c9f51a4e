#pragma once

#include <span>
#include <vector>

#include "core/formats/point_cloud.h"
#include "core/solid/rbf_points.h"

namespace slipstick {

/// The winding number of points with normals: each is a dipole as strong as the area it stands for,
/// so that the sum is about 1 inside, 0 outside, and changes smoothly across holes (Barill et al.,
/// "Fast winding numbers for soups and clouds", 2018, first order).
class WindingField {
 public:
  /// \pre `index` is that of the cloud's points.
  WindingField(const PointCloud& cloud, const PointIndex& index);

  struct Value {
    double winding = 0;
    Vec3 slope;
  };
  [[nodiscard]] Value at(Vec3 p) const;

  /// The radius of the disc about point `i` that its area was taken from: some spacings.
  [[nodiscard]] double reach(std::size_t i) const { return reaches_[i]; }

 private:
  // A group of points: its dipole, and where it acts. Children are 2i + 1 and 2i + 2.
  struct Group {
    Vec3 centre;
    Vec3 dipole;  // the sum of area times normal
    double area = 0;
    double radius = 0;
  };
  struct Dipole {
    Vec3 at;
    Vec3 strength;
  };
  void build(std::size_t group, std::span<Dipole> dipoles);
  void add(std::size_t group, Vec3 p, std::span<const Dipole> dipoles, Value& sum) const;

  std::vector<double> reaches_;
  std::vector<Dipole> dipoles_;
  std::vector<Group> groups_;
};

}  // namespace slipstick
