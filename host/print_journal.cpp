#include "host/print_journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "host/checksum.h"
#include "host/settings_changes_text.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

/// 1 counted lines of a file that are no longer sent (StatusPace); 2 knew no changes of settings,
/// and is read.
constexpr int kVersion = 3;
constexpr int kOldestVersion = 2;
constexpr std::size_t kSumSize = 9;  // '*' and eight digits
constexpr std::size_t kOthersMax = 1'000'000;
constexpr std::size_t kLayersMax = 1'000'000;
constexpr std::size_t kChangesMax = 1'000;
constexpr LineNumber kNumberMax = 1'000'000'000;

std::string record(std::string_view payload) {
  return fmt::format("{} *{:08x}\n", payload, checksum(payload));
}

// The payload of a line without its newline, if its checksum is right.
std::optional<std::string_view> payload_of(std::string_view line) {
  if (line.size() < kSumSize + 1) return {};
  const std::string_view payload = line.substr(0, line.size() - kSumSize - 1);
  if (line.substr(payload.size()) != fmt::format(" *{:08x}", checksum(payload))) return {};
  return payload;
}

void append(std::string& text, const std::optional<double>& value) {
  text += ' ';
  if (value) {
    append_exact(text, *value);
  } else {
    text += '-';
  }
}

// Takes words off the front of a record. What is missing or malformed makes it `bad`.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  std::string_view word() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }
  template <typename Integer>
  Integer integer() {
    const std::string_view text = word();
    Integer value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bad_ |= error != std::errc() || end != text.data() + text.size() || value < Integer{};
    return value;
  }
  std::optional<double> number() {
    const std::string_view text = word();
    if (text == "-") return {};
    const auto value = parse_number(text);
    bad_ |= !value;
    return value;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] bool bad() const { return bad_; }

 private:
  std::string_view rest_;
  bool bad_ = false;
};

std::optional<JournalHeader> header_of(std::string_view payload) {
  if (!payload.starts_with("H ")) return {};
  const Json json = Json::parse(payload.substr(2), nullptr, false);
  try {
    const int version = json.at("slipstick");
    if (version < kOldestVersion || version > kVersion) return {};
    return JournalHeader{json.at("folder"), json.at("words"), json.at("model"),
                         json.at("settings")};
  } catch (const Json::exception&) {
    return {};
  }
}

PrintState take_state(Words& words) {
  PrintState state;
  const int flags = words.integer<int>();
  state.relative = (flags & 1) != 0;
  state.relative_extrusion = (flags & 2) != 0;
  state.renamed = (flags & 4) != 0;
  for (auto& axis : state.position) axis = words.number();
  for (auto* value : {&state.feed, &state.nozzle, &state.bed, &state.fan, &state.top})
    *value = words.number();
  return state;
}

// Applies records to a content. False: a record that no program wrote.
class Reader {
 public:
  explicit Reader(JournalContent& content) : content_(content) {}

  bool apply(std::string_view payload) {
    Words words(payload);
    const std::string_view kind = words.word();
    if (kind == "S") return session(words);
    if (kind == "N") return other(words);
    if (kind == "I") return inserted(words);
    if (kind == "L") return layer(words);
    if (kind == "T") return taken(words);
    if (kind == "C") return change(words);
    return kind == "E" && end(words);
  }

 private:
  bool taken(Words& words) {
    const auto lines = words.integer<std::uint64_t>();
    if (!words.bad()) content_.taken = lines;
    return !words.bad();
  }

  bool end(Words& words) {
    const int end = words.integer<int>();
    if (words.bad() || end > static_cast<int>(JournalEnd::kFinished)) return false;
    content_.end = static_cast<JournalEnd>(end);
    return true;
  }

  bool session(Words& words) {
    const auto first = words.integer<LineNumber>();
    const auto base = words.integer<std::uint64_t>();
    if (words.bad() || first > kNumberMax) return false;
    content_.session = JournalSession{first, base, {}};
    content_.end = JournalEnd::kCutOff;
    content_.taken = base;
    return true;
  }

  // The number of a line behind the M110, or nothing.
  std::optional<LineNumber> number(Words& words) const {
    const auto number = words.integer<LineNumber>();
    if (words.bad() || !content_.session || content_.session->others.size() >= kOthersMax)
      return {};
    if (number <= content_.session->first || number > kNumberMax) return {};
    return number;
  }

  // A greeting or a probe that begins again gives out the same numbers once more.
  bool other(Words& words) {
    const auto number = this->number(words);
    if (!number) return false;
    auto& others = content_.session->others;
    const auto at = std::ranges::lower_bound(others, *number, {}, &OtherLine::number);
    const bool known = at != others.end() && at->number == *number;
    if (known) {
      at->text = words.rest();
    } else {
      others.insert(at, {*number, std::string(words.rest())});
    }
    return true;
  }

  bool inserted(Words& words) {
    const auto number = this->number(words);
    if (!number) return false;
    auto& others = content_.session->others;
    for (OtherLine& line : others) line.number += line.number >= *number ? 1 : 0;
    others.insert(std::ranges::lower_bound(others, *number, {}, &OtherLine::number), {*number, ""});
    return true;
  }

  bool layer(Words& words) {
    LayerMark mark;
    mark.layer = words.integer<int>();
    mark.line = words.integer<std::uint64_t>();
    mark.program = words.integer<std::uint32_t>();
    mark.state = take_state(words);
    if (words.bad() || content_.layers.size() >= kLayersMax) return false;
    // A print that was taken up begins again with a layer that is there already.
    auto& layers = content_.layers;
    while (!layers.empty() && layers.back().line >= mark.line) layers.pop_back();
    layers.push_back(mark);
    return true;
  }

  bool change(const Words& words) {
    auto change = parse_change(words.rest());
    auto& changes = content_.changes;
    if (!change || changes.size() >= kChangesMax) return false;
    if (!changes.empty() && change->from_layer < changes.back().from_layer) return false;
    changes.push_back(*std::move(change));
    return true;
  }

  JournalContent& content_;
};

tl::unexpected<Error> no_journal() {
  return fail(ErrorCode::kInput,
              "this is no journal of a print, or one of another version of slipstick");
}

}  // namespace

std::uint64_t JournalSession::job_lines(LineNumber last) const {
  const auto beyond = std::ranges::upper_bound(others, last, {}, &OtherLine::number);
  return base + static_cast<std::uint64_t>(last - first) -
         static_cast<std::uint64_t>(beyond - others.begin());
}

std::vector<OtherLine> JournalSession::tail(LineNumber last) const {
  std::vector<OtherLine> tail;
  auto at = std::ranges::upper_bound(others, last, {}, &OtherLine::number);
  for (; at != others.begin() && (at - 1)->number == last; --at, --last)
    if (!(at - 1)->text.empty()) tail.push_back(*(at - 1));
  std::ranges::reverse(tail);
  return tail;
}

std::string header_record(const JournalHeader& header) {
  const Json json{{"slipstick", kVersion},
                  {"folder", header.folder},
                  {"words", header.words},
                  {"model", header.model},
                  {"settings", header.settings}};
  return record("H " + json.dump(-1, ' ', true, Json::error_handler_t::replace));
}

std::string session_record(LineNumber first, std::uint64_t base) {
  return record(fmt::format("S {} {}", first, base));
}

std::string other_record(LineNumber number, std::string_view text) {
  return record(fmt::format("N {} {}", number, text));
}

std::string inserted_record(LineNumber number) {
  return record(fmt::format("I {}", number));
}

std::string layer_record(const LayerMark& mark) {
  const PrintState& s = mark.state;
  const int flags = (s.relative ? 1 : 0) | (s.relative_extrusion ? 2 : 0) | (s.renamed ? 4 : 0);
  std::string text = fmt::format("L {} {} {} {}", mark.layer, mark.line, mark.program, flags);
  for (const auto& axis : s.position) append(text, axis);
  for (const auto& value : {s.feed, s.nozzle, s.bed, s.fan, s.top}) append(text, value);
  return record(text);
}

std::string change_record(const SettingsChange& change) {
  return record("C " + change_text(change));
}

std::string taken_record(std::uint64_t lines) {
  return record(fmt::format("T {}", lines));
}

std::string end_record(JournalEnd end) {
  return record(fmt::format("E {}", static_cast<int>(end)));
}

Result<JournalContent> parse_journal(std::string_view bytes) {
  JournalContent content;
  Reader reader(content);
  std::size_t bad = bytes.size();  // where the first record stands that is none
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = bytes.find('\n', at);
    const auto payload = end == bytes.npos ? std::nullopt : payload_of(bytes.substr(at, end - at));
    if (at == 0) {
      auto header = payload ? header_of(*payload) : std::nullopt;
      if (!header) return no_journal();
      content.header = *std::move(header);
    } else if (payload && bad < bytes.size()) {
      return fail(ErrorCode::kInput,
                  fmt::format("the journal is damaged at byte {}, before other records: what was "
                              "printed cannot be told; start the print again",
                              bad));
    } else if (!payload || !reader.apply(*payload)) {
      bad = std::min(bad, at);
    }
    at = end == bytes.npos ? bytes.size() : end + 1;
    if (bad == bytes.size()) content.size = at;
  }
  if (content.size == 0) return no_journal();
  return content;
}

}  // namespace slipstick
