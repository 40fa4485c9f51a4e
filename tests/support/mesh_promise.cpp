#include "tests/support/mesh_promise.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/base/check.h"

namespace slipstick {

void check_mesh_promise(const TriangleMesh& mesh) {
  SLIPSTICK_CHECK(!mesh.triangles.empty());
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    SLIPSTICK_CHECK(a != b && b != c && c != a);
    used.at(a) = used.at(b) = used.at(c) = 1;
  }
  SLIPSTICK_CHECK(std::count(used.begin(), used.end(), 0) == 0);
  std::vector<std::tuple<double, double, double>> places;
  for (const Vec3 p : mesh.vertices) {
    for (const double x : {p.x, p.y, p.z}) SLIPSTICK_CHECK(std::abs(x) <= kMeshCoordinateMax);
    places.emplace_back(p.x, p.y, p.z);
  }
  std::sort(places.begin(), places.end());
  SLIPSTICK_CHECK(std::adjacent_find(places.begin(), places.end()) == places.end());
}

}  // namespace slipstick
