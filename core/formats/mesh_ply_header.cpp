#include "core/formats/mesh_ply_header.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/base/number_text.h"
#include "core/formats/mesh_words.h"

namespace slipstick {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{{
    {"char", PlyType::kInt8},
    {"int8", PlyType::kInt8},
    {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},
    {"short", PlyType::kInt16},
    {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},
    {"uint16", PlyType::kUint16},
    {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},
    {"uint", PlyType::kUint32},
    {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat},
    {"float32", PlyType::kFloat},
    {"double", PlyType::kDouble},
    {"float64", PlyType::kDouble},
}};

std::optional<PlyType> type_of(std::string_view name) {
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  return {};
}

std::optional<PlyFormat> format_of(std::string_view name) {
  if (name == "ascii") return PlyFormat::kText;
  if (name == "binary_little_endian") return PlyFormat::kLittleEndian;
  if (name == "binary_big_endian") return PlyFormat::kBigEndian;
  return {};
}

std::optional<PlyElement> parse_element(std::string_view words) {
  PlyElement element;
  element.name = take_word(words);
  const auto count = parse_number(take_word(words));
  if (!count || *count < 0 || *count > 1e15) return {};
  element.count = static_cast<std::size_t>(*count);
  return element;
}

std::optional<PlyProperty> parse_property(std::string_view words) {
  PlyProperty property;
  std::string_view type = take_word(words);
  if (type == "list") {
    property.count_type = type_of(take_word(words));
    if (!property.count_type) return {};
    type = take_word(words);
  }
  const auto known = type_of(type);
  if (!known) return {};
  property.type = *known;
  property.name = take_word(words);
  return property;
}

// The fewest bytes one element can have: in text, a digit each.
std::size_t smallest_size(const PlyElement& element, PlyFormat format) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    const PlyType type = property.count_type.value_or(property.type);
    size += format == PlyFormat::kText ? 1 : size_of(type);
  }
  return size;
}

tl::unexpected<Error> bad_line(std::string_view line) {
  constexpr std::size_t kShown = 40;
  return fail(ErrorCode::kInput, fmt::format("the PLY header has a line \"{}\" that means nothing; "
                                             "export the model again",
                                             line.substr(0, kShown)));
}

Result<void> add_line(PlyHeader& header, std::string_view line) {
  std::string_view words = line;
  const std::string_view keyword = take_word(words);
  if (keyword == "format") {
    const auto format = format_of(take_word(words));
    if (!format) return bad_line(line);
    header.format = *format;
  } else if (keyword == "element") {
    auto element = parse_element(words);
    if (!element) return bad_line(line);
    header.elements.push_back(*std::move(element));
  } else if (keyword == "property") {
    auto property = parse_property(words);
    if (!property || header.elements.empty()) return bad_line(line);
    header.elements.back().properties.push_back(*std::move(property));
  } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
    return bad_line(line);
  }
  return {};
}

Result<void> check_counts(const PlyHeader& header, std::size_t bytes) {
  for (const PlyElement& element : header.elements) {
    const std::size_t size = smallest_size(element, header.format);
    if (element.count > 0 && (size == 0 || element.count > bytes / size)) {
      return fail(ErrorCode::kInput,
                  fmt::format("{} elements \"{}\" do not fit the {} bytes of the file; it is cut "
                              "short or damaged, export it again",
                              element.count, element.name, bytes));
    }
  }
  return {};
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat:
      return 4;
    case PlyType::kDouble:
      return 8;
  }
  return 0;
}

Result<PlyHeader> take_ply_header(std::string_view& rest) {
  const auto magic = take_line(rest);
  if (!magic || *magic != "ply") {
    return fail(ErrorCode::kInput, "does not begin with \"ply\"; is the extension right?");
  }
  PlyHeader header;
  while (const auto line = take_line(rest)) {
    if (line->starts_with("end_header")) {
      if (const auto fits = check_counts(header, rest.size()); !fits) return fail(fits.error());
      return header;
    }
    if (const auto added = add_line(header, *line); !added) return fail(added.error());
  }
  return fail(ErrorCode::kInput, "the PLY header does not end; export the model again");
}

}  // namespace slipstick
