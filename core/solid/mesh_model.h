#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/formats/mesh.h"
#include "core/solid/solid.h"

namespace slipstick {

/// A triangle mesh as a solid: a point is inside if a ray from it to -x crosses an odd number of
/// triangles.
///
/// Whatever the orientation of the triangles, parity is sound where every edge has an even number
/// of them. A vertex counts as above a plane only if it is strictly above, and the point where an
/// edge crosses a plane is computed from the edge alone, so sections of such a mesh close exactly.
class MeshModel final : public Model {
 public:
  /// \pre `mesh` is as `read_mesh` promises.
  explicit MeshModel(TriangleMesh mesh);

  [[nodiscard]] Box3 bounds_under(const Affine3& map) const override;
  [[nodiscard]] std::shared_ptr<const Solid> placed(const Affine3& map) const override;
  [[nodiscard]] std::string_view kind() const override { return "mesh"; }
  [[nodiscard]] std::string size_text() const override;

  /// Edges with an odd number of triangles: where parity leaks.
  [[nodiscard]] std::int64_t open_edges() const { return open_edges_; }
  /// Edges with more than two triangles.
  [[nodiscard]] std::int64_t non_manifold_edges() const { return non_manifold_edges_; }
  /// One line for the user if the mesh is not closed, else empty.
  [[nodiscard]] std::string warning() const;

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::int64_t open_edges_ = 0;
  std::int64_t non_manifold_edges_ = 0;
};

/// Reads a mesh file; the extension of `name` says the format. \return kInput as `read_mesh`, with
/// `name`.
[[nodiscard]] Result<std::unique_ptr<MeshModel>> load_mesh_model(std::string_view bytes,
                                                                 std::string_view name);

}  // namespace slipstick
