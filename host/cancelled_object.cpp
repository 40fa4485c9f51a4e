#include "host/cancelled_object.h"

#include <algorithm>

#include "core/base/number_text.h"

namespace slipstick {
namespace {

constexpr double kLayersMax = 1'000'000;

std::string_view next_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

}  // namespace

std::string cancelled_object_text(const CancelledObject& object) {
  std::string text = std::to_string(object.layer) + ' ';
  append_exact(text, object.x);
  text += ' ';
  append_exact(text, object.y);
  return text;
}

std::optional<CancelledObject> parse_cancelled_object(std::string_view text) {
  if (text.ends_with(' ')) return {};
  const auto layer = parse_number(next_word(text));
  const auto x = parse_number(next_word(text));
  const auto y = parse_number(next_word(text));
  if (!layer || !x || !y || !text.empty()) return {};
  if (*layer < 0 || *layer > kLayersMax || *layer != static_cast<int>(*layer)) return {};
  return CancelledObject{static_cast<int>(*layer), *x, *y};
}

}  // namespace slipstick
