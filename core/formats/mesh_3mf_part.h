#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/affine.h"
#include "core/base/result.h"
#include "core/formats/mesh.h"
#include "core/formats/xml_reader.h"

namespace slipstick {

/// \file
/// One model part of a 3MF file, as it is written.

/// An object somewhere: a component of another, or an item of the build.
struct Placed3mf {
  std::uint32_t object = 0;
  std::string path;  ///< The part that has the object; empty: the same.
  Affine3 transform;
};

struct Object3mf {
  enum class Type : std::uint8_t { kModel, kOther };

  Type type = Type::kModel;
  TriangleMesh mesh;  ///< Every index is one of a vertex.
  std::vector<Placed3mf> components;
};

struct Part3mf {
  double unit = 1;  ///< mm
  std::map<std::uint32_t, Object3mf> objects;
  std::vector<Placed3mf> build;
};

/// Makes a part of its XML. Keeps at most `kMeshElementsMax` vertices, and as many triangles.
class Part3mfReader final : public XmlHandler {
 public:
  Result<void> begin(std::string_view name, const XmlAttributes& attributes) override;
  Result<void> end(std::string_view name) override;
  void declare(std::string_view prefix, std::string_view uri) override;

  [[nodiscard]] Part3mf take() { return std::move(part_); }

 private:
  enum class Tag : std::uint8_t;
  struct Known;

  [[nodiscard]] Tag tag_of(std::string_view name) const;
  Result<void> open(Tag tag, const XmlAttributes& attributes);
  Result<void> open_model(const XmlAttributes& attributes);
  Result<void> open_object(const XmlAttributes& attributes);
  Result<void> add_vertex(const XmlAttributes& attributes);
  Result<void> add_triangle(const XmlAttributes& attributes);
  [[nodiscard]] Result<void> check_extensions(std::string_view required) const;
  [[nodiscard]] Result<void> check_indices() const;

  Part3mf part_;
  std::vector<Tag> open_;
  std::map<std::string, std::string, std::less<>> prefixes_;
  std::uint32_t object_ = 0;  // that is open
  std::size_t vertices_ = 0;
  std::size_t triangles_ = 0;
};

}  // namespace slipstick
