#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

namespace slipstick {

/// Who can do something about an error.
enum class ErrorCode : std::uint8_t {
  kInput,  ///< The user: a file, an option, a model. The message says what, where and what to do.
  kUnavailable,   ///< The machine: a device or a file that is gone, a full disk.
  kTimedOut,      ///< Nobody yet: nothing came in time, trying again may help.
  kCancelled,     ///< Somebody asked for it.
  kPrinter,       ///< The printer reported a fault.
  kDisconnected,  ///< Nobody yet: the printer's port is away in the middle of a print.
};

/// An error of operation, with one line for a person.
struct Error {
  ErrorCode code = ErrorCode::kInput;
  std::string message;

  /// The same error, said to have happened in `place`: "place: message".
  [[nodiscard]] Error within(std::string_view place) const {
    return {code, std::string(place) + ": " + message};
  }

  friend bool operator==(const Error&, const Error&) = default;
};

template <typename T>
using Result = tl::expected<T, Error>;

/// `return fail(ErrorCode::kInput, "…")` from any function that returns a `Result`.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message)});
}

/// Passes an error on.
[[nodiscard]] inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace slipstick
