#include "core/formats/mesh_3mf_values.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/vec.h"
#include "core/formats/mesh_words.h"

namespace slipstick {
namespace {

constexpr std::string_view kPath =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";

struct Unit {
  std::string_view name;
  double millimetres;
};
constexpr std::array<Unit, 6> kUnits{{{"micron", 0.001},
                                      {"millimeter", 1},
                                      {"centimeter", 10},
                                      {"inch", 25.4},
                                      {"foot", 304.8},
                                      {"meter", 1000}}};

double determinant(const Affine3& map) {
  const auto& r = map.rows;
  return dot(Vec3{r[0][0], r[0][1], r[0][2]},
             cross(Vec3{r[1][0], r[1][1], r[1][2]}, Vec3{r[2][0], r[2][1], r[2][2]}));
}

// Blanks around a number are what XML calls collapsed.
std::optional<double> number_of(std::string_view text) {
  const std::string_view word = take_word(text);
  if (!take_word(text).empty()) return {};
  return parse_number(word);
}

}  // namespace

std::optional<std::uint32_t> index_in(const XmlAttributes& attributes, std::string_view name) {
  const auto value = number_in(attributes, name);
  if (!value || *value < 0 || *value > 2147483647 || *value != std::floor(*value)) return {};
  return static_cast<std::uint32_t>(*value);
}

std::optional<double> number_in(const XmlAttributes& attributes, std::string_view name) {
  const auto text = attributes.find(name);
  return text ? number_of(*text) : std::nullopt;
}

Result<double> unit_3mf(std::string_view name) {
  for (const Unit& unit : kUnits) {
    if (unit.name == name) return unit.millimetres;
  }
  return fail(ErrorCode::kInput,
              fmt::format("the unit \"{}\" is none of micron, millimeter, centimeter, inch, foot "
                          "and meter",
                          name.substr(0, 40)));
}

Result<Affine3> transform_3mf(std::string_view text) {
  Affine3 map;
  std::string_view rest = text;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto value = parse_number(take_word(rest));
    if (!value || std::abs(*value) > kMeshCoordinateMax) {
      return fail(ErrorCode::kInput,
                  fmt::format("a transform is twelve numbers of at most {:g}", kMeshCoordinateMax));
    }
    map.rows[i % 3][i / 3] = *value;
  }
  const double volume = determinant(map);
  if (!take_word(rest).empty() || !std::isfinite(volume) || volume == 0) {
    return fail(ErrorCode::kInput, "a transform is twelve numbers that do not flatten the object");
  }
  return map;
}

bool mirrors(const Affine3& map) {
  return determinant(map) < 0;
}

Result<Placed3mf> placed_3mf(const XmlAttributes& attributes) {
  const auto object = index_in(attributes, "objectid");
  if (!object) return fail(ErrorCode::kInput, "an item or a component needs an objectid");
  Placed3mf placed{*object, std::string(attributes.find(kPath).value_or("")), {}};
  if (const auto text = attributes.find("transform")) {
    const auto transform = transform_3mf(*text);
    if (!transform) return fail(transform.error());
    placed.transform = *transform;
  }
  return placed;
}

}  // namespace slipstick
