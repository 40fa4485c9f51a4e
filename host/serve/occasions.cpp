#include "host/serve/occasions.h"

#include <algorithm>
#include <array>
#include <utility>

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 9> kNames{"started",   "layer",       "paused",
                                                 "resumed",   "done",        "failed",
                                                 "cancelled", "interrupted", "stopped"};

Occasion occasion(OccasionKind kind, const Json& said) {
  Json told{{"event", name_of(kind)}};
  told.update(said);
  return {kind, std::move(told)};
}

// How a job ended.
std::optional<OccasionKind> ending(const Json& job) {
  const auto kind = occasion_kind(job.value("state", ""));
  if (!kind || *kind < OccasionKind::kDone || *kind > OccasionKind::kInterrupted) return {};
  return kind;
}

}  // namespace

std::string_view name_of(OccasionKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<OccasionKind> occasion_kind(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return {};
  return static_cast<OccasionKind>(found - kNames.begin());
}

std::string occasion_names() {
  std::string text;
  for (const std::string_view name : kNames) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

std::vector<Occasion> OccasionFinder::occasions(const EventLog::Event& event) {
  const bool is_status = event.type == "state" || event.type == "progress";
  if (!is_status && event.type != "jobs") return {};
  const Json said = Json::parse(event.data);
  if (is_status) return occasions_of_status(said);
  const auto kind = ending(said);
  return kind ? std::vector<Occasion>{occasion(*kind, said)} : std::vector<Occasion>{};
}

std::vector<Occasion> OccasionFinder::occasions_of_status(const Json& status) {
  std::vector<Occasion> found;
  const Json& job = status["job"];
  const std::int64_t id = job.is_null() ? 0 : job.value("id", std::int64_t{0});
  const std::int64_t layer = job.is_null() ? 0 : job.value("layer", std::int64_t{0});
  const std::string before = std::exchange(state_, status.value("state", ""));
  if (id != 0 && std::exchange(job_, id) != id) {
    layer_ = 0;
    found.push_back(occasion(OccasionKind::kStarted, status));
  }
  if (id == 0) job_ = 0;
  if (layer > layer_) {
    layer_ = layer;
    found.push_back(occasion(OccasionKind::kLayer, status));
  }
  if (state_ == before) return found;
  if (state_ == "paused") found.push_back(occasion(OccasionKind::kPaused, status));
  if (state_ == "printing" && before == "paused")
    found.push_back(occasion(OccasionKind::kResumed, status));
  if (state_ == "stopped") found.push_back(occasion(OccasionKind::kStopped, status));
  return found;
}

}  // namespace slipstick
