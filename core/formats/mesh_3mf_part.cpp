#include "core/formats/mesh_3mf_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/formats/mesh_3mf_values.h"
#include "core/formats/mesh_words.h"

namespace slipstick {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02|";
// Extensions that a file may require: parts elsewhere, and colours, which change no shape.
constexpr std::array<std::string_view, 2> kExtensions{
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"};

}  // namespace

enum class Part3mfReader::Tag : std::uint8_t {
  kNone,
  kModel,
  kResources,
  kObject,
  kMesh,
  kVertices,
  kVertex,
  kTriangles,
  kTriangle,
  kComponents,
  kComponent,
  kBuild,
  kItem
};

// A tag means something only where it belongs.
struct Part3mfReader::Known {
  std::string_view name;
  Tag parent;
  Tag tag;
};

Part3mfReader::Tag Part3mfReader::tag_of(std::string_view name) const {
  static constexpr std::array<Known, 11> kKnown{{{"triangle", Tag::kTriangles, Tag::kTriangle},
                                                 {"vertex", Tag::kVertices, Tag::kVertex},
                                                 {"resources", Tag::kModel, Tag::kResources},
                                                 {"object", Tag::kResources, Tag::kObject},
                                                 {"mesh", Tag::kObject, Tag::kMesh},
                                                 {"vertices", Tag::kMesh, Tag::kVertices},
                                                 {"triangles", Tag::kMesh, Tag::kTriangles},
                                                 {"components", Tag::kObject, Tag::kComponents},
                                                 {"component", Tag::kComponents, Tag::kComponent},
                                                 {"build", Tag::kModel, Tag::kBuild},
                                                 {"item", Tag::kBuild, Tag::kItem}}};
  if (!name.starts_with(kCore)) return Tag::kNone;
  name.remove_prefix(kCore.size());
  if (open_.empty()) return name == "model" ? Tag::kModel : Tag::kNone;
  const auto known = std::find_if(kKnown.begin(), kKnown.end(), [&](const Known& k) {
    return k.parent == open_.back() && k.name == name;
  });
  return known == kKnown.end() ? Tag::kNone : known->tag;
}

Result<void> Part3mfReader::begin(std::string_view name, const XmlAttributes& attributes) {
  const Tag tag = tag_of(name);
  if (open_.empty() && tag != Tag::kModel) {
    return fail(ErrorCode::kInput, "the document is not a 3MF model");
  }
  open_.push_back(tag);
  return open(tag, attributes);
}

Result<void> Part3mfReader::end(std::string_view /*name*/) {
  const Tag tag = open_.back();
  open_.pop_back();
  return tag == Tag::kObject ? check_indices() : Result<void>{};
}

void Part3mfReader::declare(std::string_view prefix, std::string_view uri) {
  if (open_.empty()) prefixes_[std::string(prefix)] = uri;
}

Result<void> Part3mfReader::open(Tag tag, const XmlAttributes& attributes) {
  const auto keep = [&](std::vector<Placed3mf>& list) -> Result<void> {
    auto placed = placed_3mf(attributes);
    if (!placed) return fail(placed.error());
    list.push_back(*std::move(placed));
    return {};
  };
  switch (tag) {
    case Tag::kModel:
      return open_model(attributes);
    case Tag::kObject:
      return open_object(attributes);
    case Tag::kVertex:
      return add_vertex(attributes);
    case Tag::kTriangle:
      return add_triangle(attributes);
    case Tag::kComponent:
      return keep(part_.objects[object_].components);
    case Tag::kItem:
      return attributes.find("printable") == "0" ? Result<void>{} : keep(part_.build);
    default:
      return {};
  }
}

Result<void> Part3mfReader::open_model(const XmlAttributes& attributes) {
  const auto unit = unit_3mf(attributes.find("unit").value_or("millimeter"));
  if (!unit) return fail(unit.error());
  part_.unit = *unit;
  return check_extensions(attributes.find("requiredextensions").value_or(""));
}

Result<void> Part3mfReader::check_extensions(std::string_view required) const {
  for (auto prefix = take_word(required); !prefix.empty(); prefix = take_word(required)) {
    const auto found = prefixes_.find(prefix);
    const std::string_view uri = found == prefixes_.end() ? "" : std::string_view(found->second);
    if (std::find(kExtensions.begin(), kExtensions.end(), uri) == kExtensions.end()) {
      return fail(ErrorCode::kInput,
                  fmt::format("the file requires the extension \"{}\" ({}), which is not known "
                              "here; export it as a plain mesh",
                              prefix.substr(0, 40), uri.substr(0, 100)));
    }
  }
  return {};
}

Result<void> Part3mfReader::open_object(const XmlAttributes& attributes) {
  const auto id = index_in(attributes, "id");
  if (!id) return fail(ErrorCode::kInput, "an object needs a whole number as its id");
  Object3mf object;
  if (attributes.find("type").value_or("model") != "model") object.type = Object3mf::Type::kOther;
  if (!part_.objects.emplace(*id, std::move(object)).second) {
    return fail(ErrorCode::kInput, fmt::format("there is an object {} already", *id));
  }
  object_ = *id;
  return {};
}

Result<void> Part3mfReader::add_vertex(const XmlAttributes& attributes) {
  const auto x = number_in(attributes, "x");
  const auto y = number_in(attributes, "y");
  const auto z = number_in(attributes, "z");
  if (!x || !y || !z) return fail(ErrorCode::kInput, "a vertex needs finite numbers x, y and z");
  if (++vertices_ > kMeshElementsMax) return fail(ErrorCode::kInput, "too many vertices");
  part_.objects[object_].mesh.vertices.push_back({*x, *y, *z});
  return {};
}

Result<void> Part3mfReader::add_triangle(const XmlAttributes& attributes) {
  const auto a = index_in(attributes, "v1");
  const auto b = index_in(attributes, "v2");
  const auto c = index_in(attributes, "v3");
  if (!a || !b || !c) return fail(ErrorCode::kInput, "a triangle needs indices v1, v2 and v3");
  if (++triangles_ > kMeshElementsMax) return fail(ErrorCode::kInput, "too many triangles");
  part_.objects[object_].mesh.triangles.push_back({*a, *b, *c});
  return {};
}

Result<void> Part3mfReader::check_indices() const {
  const TriangleMesh& mesh = part_.objects.at(object_).mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t index : mesh.triangles[i]) {
      if (index < mesh.vertices.size()) continue;
      return fail(ErrorCode::kInput,
                  fmt::format("triangle {} of object {} uses vertex {}, and there are {}", i,
                              object_, index, mesh.vertices.size()));
    }
  }
  return {};
}

}  // namespace slipstick
