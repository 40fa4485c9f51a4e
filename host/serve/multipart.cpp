#include "host/serve/multipart.h"

#include <algorithm>

namespace slipstick {
namespace {

tl::unexpected<Error> refuse(std::string_view why) {
  return fail(ErrorCode::kInput, "form: " + std::string(why));
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

// The value of `key` among `; key=value; key="value"`; a quote inside is `\"`, as curl writes it,
// or `%22`, as browsers do. Other backslashes are themselves: they are of Windows paths.
std::optional<std::string> parameter(std::string_view text, std::string_view key) {
  std::size_t at = 0;
  while ((at = text.find(';', at)) != text.npos) {
    at = text.find_first_not_of(" \t;", at);
    if (at == text.npos) break;
    const std::size_t equals = text.find('=', at);
    if (equals == text.npos) break;
    const bool found = lower(text.substr(at, equals - at)) == key;
    std::string value;
    at = equals + 1;
    if (at < text.size() && text[at] == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\' && at + 1 < text.size() && text[at + 1] == '"') ++at;
        value += text[at];
      }
    } else {
      const std::size_t end = std::min(text.find(';', at), text.size());
      value = text.substr(at, end - at);
      at = end;
    }
    if (found) return value;
  }
  return {};
}

// The value of the header `name`, which is in lower case.
std::string_view header(std::string_view head, std::string_view name) {
  while (!head.empty()) {
    const std::size_t end = std::min(head.find("\r\n"), head.size());
    const std::string_view line = head.substr(0, end);
    const std::size_t colon = line.find(':');
    if (colon != line.npos && lower(line.substr(0, colon)) == name) return line.substr(colon + 1);
    head.remove_prefix(std::min(end + 2, head.size()));
  }
  return {};
}

}  // namespace

std::optional<std::string> MultipartParser::boundary_of(std::string_view content_type) {
  const std::string_view kind = content_type.substr(0, content_type.find(';'));
  if (lower(kind) != "multipart/form-data") return {};
  auto boundary = parameter(content_type, "boundary");
  if (!boundary || boundary->empty() || boundary->size() > kBoundaryMax) return {};
  return boundary;
}

MultipartParser::MultipartParser(std::string_view boundary, Sink sink)
    : delimiter_("\r\n--" + std::string(boundary)), sink_(std::move(sink)) {}

Result<void> MultipartParser::feed(std::string_view bytes) {
  pending_ += bytes;
  while (true) {
    const auto went_on = step();
    if (!went_on) return fail(went_on.error());
    if (!*went_on) return {};
  }
}

Result<bool> MultipartParser::step() {
  switch (stage_) {
    case Stage::kPreamble:
    case Stage::kField:
    case Stage::kFile:
      return take_body();
    case Stage::kBoundary:
      if (pending_.size() < 2) return false;
      if (end_of_boundary()) return true;
      return refuse("a boundary is followed by something else");
    case Stage::kHead:
      return take_head();
    case Stage::kOver:
      break;
  }
  pending_.clear();  // an epilogue means nothing
  return false;
}

Result<bool> MultipartParser::take_body() {
  const std::size_t at = pending_.find(delimiter_);
  const bool found = at != pending_.npos;
  // What may be the beginning of a delimiter is kept.
  const std::size_t size =
      found ? at : pending_.size() - std::min(pending_.size(), delimiter_.size() - 1);
  if (const auto ok = take(std::string_view(pending_).substr(0, size)); !ok) {
    return fail(ok.error());
  }
  pending_.erase(0, found ? size + delimiter_.size() : size);
  if (!found) return false;
  end_part();
  stage_ = Stage::kBoundary;
  return true;
}

Result<void> MultipartParser::take(std::string_view bytes) {
  if (stage_ == Stage::kFile) return sink_.bytes(bytes);
  if (stage_ == Stage::kPreamble) return {};
  if (value_.size() + bytes.size() > kFieldMax) return refuse("a field is too long");
  value_ += bytes;
  return {};
}

// The line break stays: with the empty line it ends the head, even one of no lines.
bool MultipartParser::end_of_boundary() {
  if (pending_.starts_with("--")) {
    stage_ = Stage::kOver;
    return true;
  }
  stage_ = Stage::kHead;
  return pending_.starts_with("\r\n");
}

Result<bool> MultipartParser::take_head() {
  const std::size_t end = pending_.find("\r\n\r\n");
  if (std::min(end, pending_.size()) > kHeadMax) return refuse("the head of a part is too long");
  if (end == pending_.npos) return false;
  const std::size_t begin = std::min<std::size_t>(end, 2);
  const auto begun = begin_part(std::string_view(pending_).substr(begin, end - begin));
  if (!begun) return fail(begun.error());
  pending_.erase(0, end + 4);
  return true;
}

Result<void> MultipartParser::begin_part(std::string_view head) {
  if (++parts_ > kPartsMax) return refuse("too many parts");
  const std::string_view disposition = header(head, "content-disposition");
  const auto name = parameter(disposition, "name");
  if (!name) return refuse("a part has no name");
  const auto file = parameter(disposition, "filename");
  if (!file) {
    name_ = *name;
    stage_ = Stage::kField;
    return {};
  }
  if (has_file_) return refuse("more than one file");
  has_file_ = true;
  stage_ = Stage::kFile;
  return sink_.file(*file);
}

void MultipartParser::end_part() {
  if (stage_ == Stage::kField) sink_.field(std::move(name_), std::move(value_));
  name_.clear();
  value_.clear();
}

}  // namespace slipstick
