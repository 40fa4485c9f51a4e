#include "core/formats/xml_reader.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/base/check.h"

namespace slipstick {
namespace {

// expat looks at an unfinished tag again from its first byte with every piece.
constexpr std::size_t kTagMax = std::size_t{1} << 20;
constexpr std::size_t kPieceMax = std::size_t{1} << 16;

}  // namespace

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char* const* pair = pairs_; *pair != nullptr; pair += 2) {
    if (name == pair[0]) return pair[1];
  }
  return {};
}

// What expat calls back; exceptions must not pass through it.
struct XmlReader::Calls {
  static XmlReader& reader(void* user) { return *static_cast<XmlReader*>(user); }

  static void begin(void* user, const char* name, const char** attributes) noexcept {
    XmlReader& self = reader(user);
    self.bytes_since_event_ = 0;
    if (self.stopped_) return;
    const auto done = self.handler_.begin(name, XmlAttributes(attributes));
    if (!done) self.stop(done.error().message);
  }
  static void end(void* user, const char* name) noexcept {
    XmlReader& self = reader(user);
    self.bytes_since_event_ = 0;
    if (self.stopped_) return;
    if (const auto done = self.handler_.end(name); !done) self.stop(done.error().message);
  }
  static void declare(void* user, const char* prefix, const char* uri) noexcept {
    reader(user).handler_.declare(prefix == nullptr ? "" : prefix, uri == nullptr ? "" : uri);
  }
  static void document_type(void* user, const char*, const char*, const char*, int) noexcept {
    reader(user).stop("document types are not allowed");
  }
  static void other(void* user, const char*, int) noexcept { reader(user).bytes_since_event_ = 0; }
};

XmlReader::XmlReader(XmlHandler& handler)
    : parser_(XML_ParserCreateNS(nullptr, '|')), handler_(handler) {
  SLIPSTICK_CHECK(parser_ != nullptr);
  XML_SetUserData(parser_, this);
  XML_SetElementHandler(parser_, &Calls::begin, &Calls::end);
  XML_SetStartNamespaceDeclHandler(parser_, &Calls::declare);
  XML_SetStartDoctypeDeclHandler(parser_, &Calls::document_type);
  XML_SetDefaultHandler(parser_, &Calls::other);
}

XmlReader::~XmlReader() {
  XML_ParserFree(parser_);
}

void XmlReader::stop(std::string why) {
  if (stopped_) return;
  stopped_ = std::move(why);
  XML_StopParser(parser_, XML_FALSE);
}

Result<void> XmlReader::feed(std::string_view piece) {
  while (!piece.empty()) {
    const std::string_view next = piece.substr(0, kPieceMax);
    piece.remove_prefix(next.size());
    if (const auto done = parse(next, Rest::kFollows); !done) return done;
  }
  return {};
}

Result<void> XmlReader::finish() {
  return parse({}, Rest::kNone);
}

Result<void> XmlReader::parse(std::string_view piece, Rest rest) {
  bytes_since_event_ += piece.size();
  const auto status = XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()),
                                rest == Rest::kNone ? XML_TRUE : XML_FALSE);
  const auto line = XML_GetCurrentLineNumber(parser_);
  if (stopped_) return fail(ErrorCode::kInput, fmt::format("line {}: {}", line, *stopped_));
  if (status != XML_STATUS_OK) {
    return fail(ErrorCode::kInput,
                fmt::format("line {}: {}", line, XML_ErrorString(XML_GetErrorCode(parser_))));
  }
  if (bytes_since_event_ > kTagMax) {
    return fail(ErrorCode::kInput,
                fmt::format("line {}: a tag is longer than {} bytes", line, kTagMax));
  }
  return {};
}

}  // namespace slipstick
