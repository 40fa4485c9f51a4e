#pragma once

#include <string>
#include <string_view>

namespace slipstick {

/// Why the command `text` has no place in a job, in words that follow a colon; empty if it has one.
///
/// What starts, stops or writes a print on the printer's own card would run beside ours; what stops
/// the printer, or replaces its firmware, is no part of any print; and words to a host ("@pause")
/// that are not heeded would be a surprise.
[[nodiscard]] std::string_view unfit_for_job(std::string_view text);

/// Whether `text` is for people to read, as M117: it means the same when bytes that cannot be sent
/// are left out.
[[nodiscard]] bool is_message(std::string_view text);

/// `text` without the bytes that no printer takes as they are: '?' for each letter beyond ASCII, a
/// gap in M110, which would switch the check of numbers off, and no stars, quotes and backslashes.
[[nodiscard]] std::string sendable_message(std::string_view text);

}  // namespace slipstick
