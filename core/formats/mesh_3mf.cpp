#include "core/formats/mesh_3mf.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/formats/mesh_3mf_part.h"
#include "core/formats/mesh_3mf_values.h"
#include "core/formats/zip_reader.h"

namespace slipstick {
namespace {

// Where the package says that its model is.
class RootFinder final : public XmlHandler {
 public:
  Result<void> begin(std::string_view name, const XmlAttributes& attributes) override {
    constexpr std::string_view kModel =
        "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
    if (name.ends_with("|Relationship") && attributes.find("Type") == kModel && path_.empty()) {
      path_ = attributes.find("Target").value_or("");
    }
    return {};
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// The objects of all parts, read when they are first asked for.
class Package {
 public:
  explicit Package(ZipReader zip) : zip_(std::move(zip)) {}

  Result<std::string> root() {
    RootFinder finder;
    if (zip_.has("_rels/.rels")) {
      if (const auto read = parse("_rels/.rels", finder); !read) return fail(read.error());
    }
    if (finder.path().empty()) {
      return fail(ErrorCode::kInput,
                  "names no model part in _rels/.rels, as every 3MF does; export it again");
    }
    return finder.path();
  }

  Result<const Part3mf*> part(const std::string& path) {
    const std::string name = path.substr(path.starts_with('/') ? 1 : 0);
    if (const auto known = parts_.find(name); known != parts_.end()) return &known->second;
    if (parts_.size() >= k3mfPartsMax) {
      return fail(ErrorCode::kInput,
                  fmt::format("uses more than {} parts; export fewer objects", k3mfPartsMax));
    }
    Part3mfReader reader;
    if (const auto read = parse(name, reader); !read) return fail(read.error());
    return &parts_.emplace(name, reader.take()).first->second;
  }

 private:
  Result<void> parse(const std::string& name, XmlHandler& handler) {
    XmlReader xml(handler);
    const auto in_part = [&](const Result<void>& done) -> Result<void> {
      if (done) return {};
      return fail(ErrorCode::kInput,
                  fmt::format("{} {}; export it again", name, done.error().message));
    };
    const auto size = zip_.read(name, k3mfUnpackedMax - unpacked_,
                                [&](std::string_view piece) { return in_part(xml.feed(piece)); });
    if (!size) return fail(size.error());
    unpacked_ += *size;
    return in_part(xml.finish());
  }

  ZipReader zip_;
  std::map<std::string, Part3mf> parts_;
  std::size_t unpacked_ = 0;
};

// Puts the objects of the build into one mesh.
class Builder {
 public:
  Builder(Package& package, double unit) : package_(package), unit_(unit) {}

  // Adds the object that `placed`, written in the part `path`, places within `outer`.
  Result<void> add(const Placed3mf& placed, const std::string& path, const Affine3& outer) {
    const std::string& where = placed.path.empty() ? path : placed.path;
    const auto part = package_.part(where);
    if (!part) return fail(part.error());
    const auto found = (*part)->objects.find(placed.object);
    if (found == (*part)->objects.end()) {
      return fail(ErrorCode::kInput, fmt::format("object {} is used but not defined in {}; export "
                                                 "it again",
                                                 placed.object, where));
    }
    if (found->second.type != Object3mf::Type::kModel) return {};
    if (const auto ok = check(found->second, placed.object, (*part)->unit); !ok) return ok;
    const Affine3 map = composed(outer, placed.transform);
    append(found->second.mesh, map);
    around_.push_back(&found->second);
    for (const Placed3mf& component : found->second.components) {
      if (const auto added = add(component, where, map); !added) return added;
    }
    around_.pop_back();
    return {};
  }

  [[nodiscard]] TriangleMesh take() { return std::move(mesh_); }

 private:
  Result<void> check(const Object3mf& object, std::uint32_t id, double unit) {
    const auto refuse = [&](std::string_view what) {
      return fail(ErrorCode::kInput, fmt::format("object {} {}; export it again", id, what));
    };
    if (unit != unit_) return refuse("is in a part with another unit than the build");
    if (std::find(around_.begin(), around_.end(), &object) != around_.end()) {
      return refuse("is a component of itself");
    }
    if (around_.size() >= k3mfDepthMax) {
      return refuse(fmt::format("lies within more than {} others", k3mfDepthMax - 1));
    }
    if (++instances_ > k3mfInstancesMax) {
      return refuse(
          fmt::format("is more than the {} objects that can be placed", k3mfInstancesMax));
    }
    if (object.mesh.vertices.size() > kMeshElementsMax - mesh_.vertices.size() ||
        object.mesh.triangles.size() > kMeshElementsMax - mesh_.triangles.size()) {
      return refuse(
          fmt::format("makes the build larger than {} vertices or triangles", kMeshElementsMax));
    }
    return {};
  }

  void append(const TriangleMesh& mesh, const Affine3& map) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (const Vec3 p : mesh.vertices) mesh_.vertices.push_back(map(p));
    const bool turned = mirrors(map);
    for (const auto& [a, b, c] : mesh.triangles) {
      mesh_.triangles.push_back({first + a, first + (turned ? c : b), first + (turned ? b : c)});
    }
  }

  Package& package_;
  double unit_;
  std::vector<const Object3mf*> around_;  // what is being added, outermost first
  std::size_t instances_ = 0;
  TriangleMesh mesh_;
};

}  // namespace

Result<TriangleMesh> read_3mf(std::string_view bytes) {
  auto zip = ZipReader::open(bytes);
  if (!zip) return fail(zip.error());
  Package package(*std::move(zip));
  const auto root = package.root();
  if (!root) return fail(root.error());
  const auto part = package.part(*root);
  if (!part) return fail(part.error());
  const double unit = (*part)->unit;
  Builder builder(package, unit);
  for (const Placed3mf& item : (*part)->build) {
    const auto added = builder.add(item, *root, scaling({unit, unit, unit}));
    if (!added) return fail(added.error());
  }
  TriangleMesh mesh = builder.take();
  if (mesh.triangles.empty()) {
    return fail(ErrorCode::kInput,
                "has nothing to be built: no item of its build is a model with "
                "triangles; put the object on the plate and export it again");
  }
  return mesh;
}

}  // namespace slipstick
