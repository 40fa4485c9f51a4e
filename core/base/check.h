#pragma once

namespace slipstick {

/// \file
/// Checks for programmers' errors. Errors of operation are `Result`s (result.h).
///
/// A failed check is on in every build: stopping beats continuing wrongly. Before it aborts it
/// calls the hook, with which the host makes the printer safe.

/// What a failed check calls first. Must be async-signal-safe and must not return control to
/// callers.
using CheckHook = void (*)();

/// Installs `hook` for the rest of the process; null removes it. Any thread.
void set_check_hook(CheckHook hook) noexcept;

/// Calls the hook, prints the place on standard error, aborts.
[[noreturn]] void check_failed(const char* condition, const char* file, int line) noexcept;

}  // namespace slipstick

#define SLIPSTICK_CHECK(condition) \
  ((condition) ? void() : ::slipstick::check_failed(#condition, __FILE__, __LINE__))

#ifdef NDEBUG
#define SLIPSTICK_DCHECK(condition) void()
#else
#define SLIPSTICK_DCHECK(condition) SLIPSTICK_CHECK(condition)
#endif
