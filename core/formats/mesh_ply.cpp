#include "core/formats/mesh_ply.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "core/formats/mesh_build.h"
#include "core/formats/mesh_ply_header.h"
#include "core/formats/mesh_ply_values.h"

namespace slipstick {
namespace {

constexpr double kListLengthMax = 1 << 20;

enum class Meaning : std::uint8_t { kNone, kX, kY, kZ, kPolygon };

Meaning meaning_of(const PlyElement& element, const PlyProperty& property) {
  const std::string_view name = property.name;
  if (element.name == "vertex" && !property.count_type) {
    if (name == "x") return Meaning::kX;
    if (name == "y") return Meaning::kY;
    if (name == "z") return Meaning::kZ;
  }
  const bool indices = name == "vertex_indices" || name == "vertex_index";
  if (element.name == "face" && property.count_type && indices) return Meaning::kPolygon;
  return Meaning::kNone;
}

class BodyReader {
 public:
  BodyReader(const PlyHeader& header, std::string_view body) : values_(header.format, body) {}

  // False if the file ends too early or has something else than numbers.
  bool read(const PlyElement& element) {
    std::vector<Meaning> meanings;
    for (const PlyProperty& p : element.properties) meanings.push_back(meaning_of(element, p));
    for (std::size_t i = 0; i < element.count; ++i) {
      Vec3 point;
      for (std::size_t k = 0; k < meanings.size(); ++k) {
        if (!read(element.properties[k], meanings[k], point)) return false;
      }
      if (element.name == "vertex") mesh_.vertices.push_back(point);
    }
    return true;
  }

  [[nodiscard]] TriangleMesh take() { return std::move(mesh_); }

 private:
  bool read(const PlyProperty& property, Meaning meaning, Vec3& point) {
    if (property.count_type) return read_list(property, meaning);
    const auto value = values_.next(property.type);
    if (!value) return false;
    if (meaning == Meaning::kX) point.x = *value;
    if (meaning == Meaning::kY) point.y = *value;
    if (meaning == Meaning::kZ) point.z = *value;
    return true;
  }

  // Ends with the bytes, whatever the count says.
  bool read_list(const PlyProperty& property, Meaning meaning) {
    const auto count = values_.next(*property.count_type);
    if (!count || *count < 0 || *count > kListLengthMax) return false;
    corners_.clear();
    const auto length = static_cast<std::size_t>(*count);
    for (std::size_t i = 0; i < length; ++i) {
      const auto value = values_.next(property.type);
      if (!value) return false;
      if (meaning == Meaning::kPolygon) corners_.push_back(to_vertex_index(*value));
    }
    add_polygon(mesh_, corners_);
    return true;
  }

  PlyValues values_;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> corners_;
};

bool has_coordinates(const PlyHeader& header) {
  int found = 0;
  for (const PlyElement& element : header.elements) {
    for (const PlyProperty& property : element.properties) {
      const Meaning meaning = meaning_of(element, property);
      found += static_cast<int>(meaning != Meaning::kNone && meaning != Meaning::kPolygon);
    }
  }
  return found == 3;
}

}  // namespace

Result<TriangleMesh> read_ply(std::string_view bytes) {
  std::string_view body = bytes;
  const auto header = take_ply_header(body);
  if (!header) return fail(header.error());
  if (!has_coordinates(*header)) {
    return fail(ErrorCode::kInput, "its vertices lack x, y or z; export the model again");
  }
  BodyReader reader(*header, body);
  for (const PlyElement& element : header->elements) {
    if (!reader.read(element)) {
      return fail(ErrorCode::kInput,
                  fmt::format("ends or turns into something else than finite numbers in its {} "
                              "elements \"{}\"; it is cut short or damaged, export it again",
                              element.count, element.name));
    }
  }
  return reader.take();
}

}  // namespace slipstick
