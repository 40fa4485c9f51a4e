#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "host/serve/printer_status.h"
#include "host/serve/store.h"

namespace slipstick {

/// \file
/// The printer and its job in OctoPrint's words, for answers and for the push socket.

/// The release whose answers are given.
inline constexpr const char* kOctoPrintRelease = "1.10.0";

/// What OctoPrint's clients are told of, at one moment.
struct OctoMoment {
  PrinterStatus status;
  std::string name;                ///< Of the file that is printed, else selected; or empty.
  std::optional<StoredFile> file;  ///< If it is still there.
  std::int64_t time = 0;           ///< Seconds since 1970.
};

/// "Operational", "Printing", "Paused", "Cancelling" or "Error".
[[nodiscard]] std::string_view octo_state(PrinterActivity activity);

/// `{"text": …, "flags": {…}}`.
[[nodiscard]] nlohmann::ordered_json octo_state_of(PrinterActivity activity);
/// `{"tool0": {"actual", "target", "offset"}, "bed": …}`: what is known.
[[nodiscard]] nlohmann::ordered_json octo_temperatures(const std::optional<Temperatures>& seen);
/// `{"file": {…}, …}`.
[[nodiscard]] nlohmann::ordered_json octo_job_of(const OctoMoment& moment);
/// `{"completion": …, …}`; all of it null between prints.
[[nodiscard]] nlohmann::ordered_json octo_progress(const PrinterStatus& status);
/// "machinecode" and "gcode", or "model" and "stl", of a file by its name.
[[nodiscard]] nlohmann::ordered_json octo_type_path(std::string_view name);

}  // namespace slipstick
