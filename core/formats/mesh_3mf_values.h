#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/affine.h"
#include "core/base/result.h"
#include "core/formats/mesh_3mf_part.h"
#include "core/formats/xml_reader.h"

namespace slipstick {

/// \file
/// What attributes of 3MF say. Errors tell what is wrong, not where.

/// A whole number; nothing if the attribute is missing or something else.
[[nodiscard]] std::optional<std::uint32_t> index_in(const XmlAttributes& attributes,
                                                    std::string_view name);

/// A finite number; nothing if the attribute is missing or something else.
[[nodiscard]] std::optional<double> number_in(const XmlAttributes& attributes,
                                              std::string_view name);

/// Millimetres of a unit by name.
[[nodiscard]] Result<double> unit_3mf(std::string_view name);

/// A transform of twelve numbers, for row vectors, as a map. \return kInput if it is none or not
/// invertible.
[[nodiscard]] Result<Affine3> transform_3mf(std::string_view text);

/// Turns the orientation of what it maps around.
[[nodiscard]] bool mirrors(const Affine3& map);

/// The object, path and transform of a component or an item.
[[nodiscard]] Result<Placed3mf> placed_3mf(const XmlAttributes& attributes);

}  // namespace slipstick
