#include "core/formats/mesh_build.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace slipstick {
namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

struct VertexHash {
  std::size_t operator()(Vec3 p) const {
    std::uint64_t hash = 0;
    for (const double c : {p.x, p.y, p.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

// -0 and 0 are equal but differ in their bits.
Vec3 without_negative_zero(Vec3 p) {
  return p + Vec3{0, 0, 0};
}

bool acceptable(Vec3 p) {
  const auto in_range = [](double c) { return std::abs(c) <= kMeshCoordinateMax; };
  return in_range(p.x) && in_range(p.y) && in_range(p.z);
}

Result<void> check(const TriangleMesh& raw) {
  if (raw.triangles.empty()) {
    return fail(ErrorCode::kInput,
                "has no faces; a mesh needs triangles, a point cloud needs normals");
  }
  for (std::size_t i = 0; i < raw.vertices.size(); ++i) {
    const Vec3 p = raw.vertices[i];
    if (!acceptable(p)) {
      return fail(ErrorCode::kInput,
                  fmt::format("vertex {} is ({:g}, {:g}, {:g}); coordinates must be finite and at "
                              "most {:g}; export the model again",
                              i, p.x, p.y, p.z, kMeshCoordinateMax));
    }
  }
  for (std::size_t i = 0; i < raw.triangles.size(); ++i) {
    for (const std::uint32_t index : raw.triangles[i]) {
      if (index >= raw.vertices.size()) {
        return fail(ErrorCode::kInput,
                    fmt::format("triangle {} uses a vertex that does not exist (there are {}); "
                                "export the model again",
                                i, raw.vertices.size()));
      }
    }
  }
  return {};
}

}  // namespace

void add_polygon(TriangleMesh& mesh, std::span<const std::uint32_t> corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

std::uint32_t to_vertex_index(double value) {
  const bool fits = value >= 0 && value < kNoVertex;
  return fits ? static_cast<std::uint32_t>(value) : kNoVertex;
}

Result<TriangleMesh> cleaned(const TriangleMesh& raw) {
  if (const auto checked = check(raw); !checked) return fail(checked.error());

  TriangleMesh mesh;
  mesh.triangles.reserve(raw.triangles.size());
  std::unordered_map<Vec3, std::uint32_t, VertexHash> known;
  known.reserve(raw.vertices.size());
  std::vector<std::uint32_t> welded(raw.vertices.size(), kNoVertex);
  const auto weld = [&](std::uint32_t index) {
    if (welded[index] == kNoVertex) {
      const Vec3 p = without_negative_zero(raw.vertices[index]);
      const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
      const auto [entry, added] = known.emplace(p, next);
      if (added) mesh.vertices.push_back(p);
      welded[index] = entry->second;
    }
    return welded[index];
  };
  for (const auto& [a, b, c] : raw.triangles) {
    const Vec3 p = raw.vertices[a], q = raw.vertices[b], r = raw.vertices[c];
    if (p == q || q == r || r == p) continue;  // before its other vertices are taken for used
    mesh.triangles.push_back({weld(a), weld(b), weld(c)});
  }
  if (mesh.triangles.empty()) {
    return fail(ErrorCode::kInput, "has no faces other than degenerate ones; export it again");
  }
  return mesh;
}

}  // namespace slipstick
