#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/formats/mesh.h"
#include "core/solid/mesh_cut.h"
#include "core/solid/mesh_orientation.h"
#include "core/solid/solid.h"

namespace slipstick {

/// A triangle mesh as a solid: whether a point is inside is told by the triangles that a ray from
/// it to -x crosses, by winding number or by parity.
///
/// Winding is sound where every edge is run through equally often both ways; faces turned the wrong
/// way are turned back first. Parity is sound where every edge has an even number of triangles. A
/// vertex counts as above a plane only if it is strictly above, and the point where an edge crosses
/// a plane is computed from the edge alone, so sections of such a mesh close exactly.
class MeshModel final : public Model {
 public:
  /// \pre `mesh` is as `read_mesh` promises.
  explicit MeshModel(TriangleMesh mesh, Winding winding = Winding::kNonzero);

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override;
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override;
  [[nodiscard]] std::string_view kind() const override { return "mesh"; }
  [[nodiscard]] std::string size_text() const override;

  /// As it counts: with faces turned round where they were.
  [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
  [[nodiscard]] Winding winding() const { return winding_; }

  /// Edges with an odd number of triangles: where parity leaks.
  [[nodiscard]] std::int64_t open_edges() const { return open_edges_; }
  /// Edges with more than two triangles.
  [[nodiscard]] std::int64_t non_manifold_edges() const { return non_manifold_edges_; }
  /// Triangles turned round because their neighbours faced the other way; 0 with parity.
  [[nodiscard]] std::int64_t turned() const { return orientation_.turned; }
  /// One line for the user if the mesh is not closed or was corrected, else empty.
  [[nodiscard]] std::string warning() const;

 private:
  [[nodiscard]] bool closed() const;

  Winding winding_;
  Orientation orientation_;
  std::shared_ptr<const TriangleMesh> mesh_;
  std::int64_t open_edges_ = 0;
  std::int64_t non_manifold_edges_ = 0;
};

/// Reads a mesh file; the extension of `name` says the format. \return kInput as `read_mesh`, with
/// `name`.
[[nodiscard]] Result<std::unique_ptr<MeshModel>> load_mesh_model(
    std::string_view bytes, std::string_view name, Winding winding = Winding::kNonzero);

}  // namespace slipstick
