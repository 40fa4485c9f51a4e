#include "core/solid/mesh_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/solid/mesh_model_intervals.h"
#include "core/solid/mesh_model_section.h"

namespace slipstick {
namespace {

class MeshSolid final : public Solid {
 public:
  MeshSolid(std::shared_ptr<const TriangleMesh> mesh, const Affine3& map, Winding winding)
      : mesh_(std::move(mesh)), winding_(winding) {
    vertices_.reserve(mesh_->vertices.size());
    for (const Vec3 p : mesh_->vertices) {
      vertices_.push_back(map(p));
      bounds_ = bounds_.with(vertices_.back());
    }
    std::vector<CoordinateRange> heights;
    heights.reserve(mesh_->triangles.size());
    for (const auto& [a, b, c] : mesh_->triangles) {
      const auto [low, high] = std::minmax({vertices_[a].z, vertices_[b].z, vertices_[c].z});
      heights.push_back({low, high});
    }
    by_z_ = IntervalIndex(heights);
  }

  [[nodiscard]] Box3 bounds() const override { return bounds_; }

  [[nodiscard]] std::unique_ptr<Section> section(double z) const override {
    std::vector<OutlineSegment> segments;
    by_z_.for_each_near(z, [&](std::uint32_t i) {
      const auto& [a, b, c] = mesh_->triangles[i];
      if (const auto cut = cut_of({vertices_[a], vertices_[b], vertices_[c]}, z)) {
        segments.push_back(*cut);
      }
    });
    return std::make_unique<OutlineSection>(std::move(segments), winding_);
  }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  Winding winding_;
  std::vector<Vec3> vertices_;
  Box3 bounds_;
  IntervalIndex by_z_;
};

// One number for each side of each triangle, the same for the same two vertices; sorted.
std::vector<std::uint64_t> sorted_edges(const TriangleMesh& mesh) {
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({t[i], t[(i + 1) % 3]});
      edges.push_back((std::uint64_t{low} << 32) | high);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

MeshModel::MeshModel(TriangleMesh mesh, Winding winding) : winding_(winding) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) SLIPSTICK_CHECK(v < mesh.vertices.size());
  }
  if (winding == Winding::kNonzero) orientation_ = orient(mesh);
  mesh_ = std::make_shared<const TriangleMesh>(std::move(mesh));
  const std::vector<std::uint64_t> edges = sorted_edges(*mesh_);
  for (auto first = edges.begin(); first != edges.end();) {
    const auto end =
        std::find_if(first, edges.end(), [&](std::uint64_t edge) { return edge != *first; });
    if ((end - first) % 2 != 0) ++open_edges_;
    if (end - first > 2) ++non_manifold_edges_;
    first = end;
  }
}

bool MeshModel::closed() const {
  return winding_ == Winding::kNonzero ? orientation_.unbalanced == 0 : open_edges_ == 0;
}

Box3 MeshModel::bounds_under(const Affine3& map) const {
  Box3 box;
  for (const Vec3 p : mesh_->vertices) box = box.with(map(p));
  return box;
}

std::shared_ptr<const Solid> MeshModel::placed(const Affine3& map) const {
  return std::make_shared<MeshSolid>(mesh_, map, winding_);
}

std::string MeshModel::size_text() const {
  return fmt::format("{} triangles", mesh_->triangles.size());
}

std::string MeshModel::warning() const {
  std::vector<std::string> parts;
  if (!closed()) {
    const std::int64_t edges = open_edges_ > 0 ? open_edges_ : orientation_.unbalanced;
    parts.push_back(fmt::format(
        "not closed: {} boundary edges, the inside may leak; repair the mesh or use --as ldni",
        edges));
  }
  if (orientation_.copies > 0) {
    parts.push_back(fmt::format("{} faces are there more than once", orientation_.copies));
  }
  if (orientation_.turned > 0) {
    parts.push_back(
        fmt::format("{} faces were inside out and have been turned", orientation_.turned));
  }
  if (parts.empty() && winding_ == Winding::kNonzero && non_manifold_edges_ > 0) {
    parts.push_back(fmt::format("{} edges have more than two faces; overlaps count as solid",
                                non_manifold_edges_));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

Result<std::unique_ptr<MeshModel>> load_mesh_model(std::string_view bytes, std::string_view name,
                                                   Winding winding) {
  const std::size_t dot = name.rfind('.');
  const std::string_view extension =
      dot == std::string_view::npos ? std::string_view{} : name.substr(dot + 1);
  auto mesh = read_mesh(bytes, extension);
  if (!mesh) return fail(mesh.error().within(name));
  return std::make_unique<MeshModel>(*std::move(mesh), winding);
}

}  // namespace slipstick
