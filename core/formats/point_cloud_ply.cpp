#include "core/formats/point_cloud_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/formats/mesh_ply_header.h"
#include "core/formats/mesh_ply_values.h"

namespace slipstick {
namespace {

constexpr std::array<std::string_view, 6> kNames{"x", "y", "z", "nx", "ny", "nz"};
constexpr double kListLengthMax = 1 << 20;

// Which of the names the property is; their number if none.
std::size_t slot_of(const PlyProperty& property) {
  if (property.count_type) return kNames.size();
  const auto* const at = std::find(kNames.begin(), kNames.end(), property.name);
  return static_cast<std::size_t>(at - kNames.begin());
}

bool has_all(const PlyElement& element) {
  std::array<bool, kNames.size() + 1> found{};
  for (const PlyProperty& p : element.properties) found[slot_of(p)] = true;
  return std::all_of(found.begin(), found.end() - 1, [](bool is) { return is; });
}

bool skip_list(PlyValues& values, const PlyProperty& property) {
  const auto count = values.next(*property.count_type);
  if (!count || !(*count >= 0 && *count <= kListLengthMax)) return false;
  for (auto i = static_cast<std::size_t>(*count); i > 0; --i) {
    if (!values.next(property.type)) return false;
  }
  return true;
}

// One element; false if the file ends or turns into something else than numbers.
bool read_element(PlyValues& values, const PlyElement& element, std::array<double, 7>& slots) {
  for (const PlyProperty& p : element.properties) {
    if (p.count_type) {
      if (!skip_list(values, p)) return false;
      continue;
    }
    const auto value = values.next(p.type);
    if (!value) return false;
    slots[slot_of(p)] = *value;
  }
  return true;
}

tl::unexpected<Error> no_normals() {
  return fail(ErrorCode::kInput,
              "has no vertices with x y z nx ny nz; points need normals, export them as well");
}

}  // namespace

Result<PointCloud> read_ply_points(std::string_view bytes) {
  std::string_view body = bytes;
  const auto header = take_ply_header(body);
  if (!header) return fail(header.error());
  PlyValues values(header->format, body);
  for (const PlyElement& element : header->elements) {
    const bool wanted = element.name == "vertex";
    if (wanted && !has_all(element)) return no_normals();
    PointCloud cloud;
    for (std::size_t i = 0; i < element.count; ++i) {
      std::array<double, 7> s{};
      if (!read_element(values, element, s)) {
        return fail(ErrorCode::kInput,
                    fmt::format("ends or turns into something else than numbers at element {} of "
                                "{} \"{}\"; it is cut short or damaged",
                                i, element.count, element.name));
      }
      if (!wanted) continue;
      cloud.points.push_back({s[0], s[1], s[2]});
      cloud.normals.push_back({s[3], s[4], s[5]});
    }
    if (wanted) return cloud;
  }
  return no_normals();
}

bool ply_is_point_cloud(std::string_view bytes) {
  const auto header = take_ply_header(bytes);
  if (!header) return false;
  return std::none_of(header->elements.begin(), header->elements.end(),
                      [](const PlyElement& e) { return e.name == "face" && e.count > 0; });
}

}  // namespace slipstick
