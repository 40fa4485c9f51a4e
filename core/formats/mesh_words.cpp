#include "core/formats/mesh_words.h"

#include "core/base/number_text.h"

namespace slipstick {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

}  // namespace

std::optional<std::string_view> take_line(std::string_view& rest) {
  if (rest.empty()) return {};
  const std::size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view take_word(std::string_view& rest) {
  const std::size_t begin = rest.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    rest = {};
    return {};
  }
  rest.remove_prefix(begin);
  const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
  rest.remove_prefix(word.size());
  return word;
}

std::optional<Vec3> take_point(std::string_view& rest) {
  const auto x = parse_number(take_word(rest));
  const auto y = parse_number(take_word(rest));
  const auto z = parse_number(take_word(rest));
  if (!x || !y || !z) return {};
  return Vec3{*x, *y, *z};
}

}  // namespace slipstick
