#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace slipstick {

/// What somebody may do. Each includes those before it: whoever may print may look, and a program
/// that is printed heats and moves anyway.
enum class Scope : std::uint8_t {
  kRead,     ///< Look: state, files, layers, queue, events.
  kPrint,    ///< Upload and remove files; queue, pause, resume and cancel prints; stop the printer.
  kControl,  ///< Heat, move, say commands.
  kAdmin,    ///< Accounts and keys.
};
/// "read", "print", "control", "admin".
[[nodiscard]] std::string_view name_of(Scope scope);
[[nodiscard]] std::optional<Scope> scope_named(std::string_view name);

/// Who asks.
struct Caller {
  enum class By : std::uint8_t {
    kNothing,  ///< Nobody that is known.
    kMachine,  ///< Somebody on this machine, where no account was made.
    kFileKey,  ///< The key in DATA/api_key.
    kKey,      ///< A key that an account made.
    kSession,  ///< A browser in which somebody logged in.
  };
  By by = By::kNothing;
  Scope scope = Scope::kRead;
  std::int64_t id = 0;    ///< Of the session or the key.
  std::int64_t user = 0;  ///< Whose it is.
  std::string name;       ///< Of the user or the key.
};

}  // namespace slipstick
