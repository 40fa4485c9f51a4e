#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/box.h"
#include "core/base/rng.h"
#include "core/formats/mesh.h"
#include "core/formats/point_cloud.h"
#include "core/solid/solid.h"
#include "tests/support/betti.h"

namespace slipstick::test {

/// A shape {f <= 0} with known topology, from which every representation can be made.
struct Shape {
  std::string name;
  std::function<double(Vec3)> f;
  Box3 box;  ///< Holds it with room to spare.
  Betti betti;
};

/// Sphere, torus, two linked tori, box with a tunnel, hollow sphere, gyroid in a sphere.
[[nodiscard]] std::vector<Shape> shapes();

/// Random points of the surface with outward normals: Newton's way from random points of the box.
[[nodiscard]] PointCloud cloud_of(const Shape& shape, std::size_t count, Rng& rng);

/// A closed mesh, oriented outwards, by marching tetrahedra over `cells` cubes along the longest
/// side.
[[nodiscard]] TriangleMesh mesh_of(const Shape& shape, int cells);

/// The images of `model` as it lies on the bed when sliced along `direction`, one `h` apart, the
/// lattice `h` fine.
[[nodiscard]] std::vector<BitImage> sliced(const Model& model, Vec3 direction, double h);

}  // namespace slipstick::test
