#pragma once

#include <string>
#include <vector>

namespace slipstick::test {

/// What a client is known to need of a reply.
struct WantedOfReply {
  enum class Kind { kHeader, kMember, kTextThatBegins, kValue };
  Kind kind = Kind::kMember;
  std::string where;  ///< Name of a header in lower case, or a JSON pointer.
  std::string what;   ///< A text, or the value as JSON.
};

/// Bytes that are sent, and the reply that is then waited for.
struct DialogueTurn {
  bool connects = false;  ///< On a new connection.
  std::string bytes;
  int status = 0;
  std::vector<WantedOfReply> wanted;
};

/// A recorded dialogue; tests/host/dialogues/README.md describes the format.
struct HttpDialogue {
  struct Stored {
    std::string name;
    int size = 0;
  };
  std::vector<DialogueTurn> turns;
  std::vector<Stored> stored;
  std::string printed;  ///< Or empty.
};

/// \pre the file is well-formed: a mistake in it ends the program.
[[nodiscard]] HttpDialogue read_dialogue(const std::string& path);

/// `text` with every `{name}` replaced by `value`.
[[nodiscard]] std::string with_value(std::string text, const std::string& name,
                                     const std::string& value);

}  // namespace slipstick::test
