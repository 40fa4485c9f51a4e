#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/serve/event_log.h"

namespace slipstick {

/// What happens to a printer and is worth a hook.
enum class OccasionKind : std::uint8_t {
  kStarted,  ///< A print.
  kLayer,    ///< The first line of a layer was handed to the sender.
  kPaused,
  kResumed,
  kDone,
  kFailed,
  kCancelled,
  kInterrupted,
  kStopped,  ///< By an emergency stop, a fault or a lost printer: somebody must look at it.
};
/// "started", "layer", "paused", …
[[nodiscard]] std::string_view name_of(OccasionKind kind);
[[nodiscard]] std::optional<OccasionKind> occasion_kind(std::string_view name);
/// "started, layer, paused, …"
[[nodiscard]] std::string occasion_names();

struct Occasion {
  OccasionKind kind = OccasionKind::kStarted;
  nlohmann::ordered_json told;  ///< {"event", and what the event log said}
};

/// Finds occasions in the events of the daemon. Where layers are done faster than they are told,
/// the latest stands for all of them.
class OccasionFinder {
 public:
  [[nodiscard]] std::vector<Occasion> occasions(const EventLog::Event& event);

 private:
  std::vector<Occasion> occasions_of_status(const nlohmann::ordered_json& status);

  std::int64_t job_ = 0;
  std::int64_t layer_ = 0;
  std::string state_ = "idle";
};

}  // namespace slipstick
