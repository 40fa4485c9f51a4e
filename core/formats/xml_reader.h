#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

struct XML_ParserStruct;

namespace slipstick {

/// The attributes of one tag. A name in a namespace is "URI|name".
class XmlAttributes {
 public:
  /// `pairs` are names and values in turn, ended by a null pointer.
  explicit XmlAttributes(const char* const* pairs) : pairs_(pairs) {}

  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char* const* pairs_;
};

/// What is done with the tags of a document, in its order. Names are "URI|name".
class XmlHandler {
 public:
  XmlHandler() = default;
  XmlHandler(const XmlHandler&) = delete;
  XmlHandler& operator=(const XmlHandler&) = delete;
  virtual ~XmlHandler() = default;

  virtual Result<void> begin(std::string_view name, const XmlAttributes& attributes) = 0;
  virtual Result<void> end(std::string_view /*name*/) { return {}; }
  /// A prefix is declared; comes before the `begin` of the tag that does so.
  virtual void declare(std::string_view /*prefix*/, std::string_view /*uri*/) {}
};

/// Reads XML with namespaces piece by piece, by the library expat; keeps no more than one tag, of
/// at most about 1 MiB. Document types, and with them entities, are refused.
class XmlReader {
 public:
  /// `handler` must outlive the reader.
  explicit XmlReader(XmlHandler& handler);
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;
  ~XmlReader();

  /// \return kInput, "line N: what", for what is not well formed and for the handler's error.
  [[nodiscard]] Result<void> feed(std::string_view piece);
  /// The document ends here.
  [[nodiscard]] Result<void> finish();

 private:
  struct Calls;
  enum class Rest : std::uint8_t { kFollows, kNone };

  [[nodiscard]] Result<void> parse(std::string_view piece, Rest rest);
  void stop(std::string why);

  XML_ParserStruct* parser_;
  XmlHandler& handler_;
  std::optional<std::string> stopped_;  // why
  std::size_t bytes_since_event_ = 0;
};

}  // namespace slipstick
