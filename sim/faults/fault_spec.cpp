#include "sim/faults/fault_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"
#include "sim/faults/fault_names.h"

namespace slipstick {

namespace {

constexpr double kSecondsMax = 1e6;
constexpr double kLinesMax = 1e9;
constexpr std::size_t kWordsMax = 256;
constexpr std::string_view kLine = "line";

tl::unexpected<Error> wrong(std::string_view text, const std::string& why) {
  return fail(ErrorCode::kInput, fmt::format("fault '{}': {}", text, why));
}

std::optional<double> number_within(std::string_view text, double most) {
  const auto number = parse_number(text);
  return number && *number >= 0 && *number <= most ? number : std::nullopt;
}

Moment moment_of(double seconds) {
  return Moment(static_cast<Moment::rep>(std::llround(seconds * 1e6)));
}

std::optional<FaultWhen> when_of(std::string_view text) {
  if (text.starts_with(kLine)) {
    const auto line = number_within(text.substr(kLine.size()), kLinesMax);
    if (!line || *line != std::floor(*line)) return std::nullopt;
    return FaultWhen{.from = {}, .line = static_cast<std::int64_t>(*line), .lasts = {}};
  }
  const std::size_t dash = std::min(text.find('-'), text.size());
  const auto from = number_within(text.substr(0, dash), kSecondsMax);
  if (!from) return std::nullopt;
  FaultWhen when{.from = moment_of(*from), .line = {}, .lasts = {}};
  if (dash == text.size()) return when;
  const auto to = number_within(text.substr(dash + 1), kSecondsMax);
  if (!to || *to <= *from) return std::nullopt;
  when.lasts = moment_of(*to - *from);
  return when;
}

/// What to give instead of a wrong value.
std::string wanted(const FaultName& name) {
  switch (name.value) {
    case FaultValue::kShare:
      return "give a share, 0 to 1";
    case FaultValue::kSeconds:
      return fmt::format("give seconds, 0 to {}", name.most);
    case FaultValue::kWords:
      return fmt::format("give words, as in {}=ok, up to {} bytes", name.name, kWordsMax);
    case FaultValue::kNone:
      break;
  }
  return "it has no value";
}

}  // namespace

Result<FaultSpec> FaultSpec::parse(std::string_view text) {
  const std::size_t at = std::min(text.rfind('@'), text.size());
  const std::string_view before = text.substr(0, at);
  const std::size_t equals = std::min(before.find('='), before.size());
  const auto names = fault_names();
  const auto name = std::ranges::find(names, before.substr(0, equals), &FaultName::name);
  if (name == names.end())
    return wrong(text, "there is none of this name, but " + list_of_faults());

  FaultSpec spec;
  spec.name_ = name->name;
  spec.number_ = name->usual;
  const bool has_value = equals < before.size();
  const std::string_view value = has_value ? before.substr(equals + 1) : std::string_view();
  if (name->value == FaultValue::kWords) {
    if (value.empty() || value.size() > kWordsMax) return wrong(text, wanted(*name));
    spec.words_ = value;
  } else if (has_value) {
    const auto number = number_within(value, name->most);
    if (!number || name->value == FaultValue::kNone) return wrong(text, wanted(*name));
    spec.number_ = *number;
  }
  if (at == text.size()) return spec;
  const auto when = when_of(text.substr(at + 1));
  if (!when) return wrong(text, "give when as SECONDS, FROM-TO or lineN behind the @");
  spec.when_ = *when;
  return spec;
}

FaultSpec FaultSpec::from(Moment now, std::int64_t lines) const {
  FaultSpec shifted = *this;
  FaultWhen& when = shifted.when_;
  if (when.line) {
    *when.line += lines;
  } else {
    when.from = when.from.value_or(Moment(0)) + now;
  }
  return shifted;
}

}  // namespace slipstick
