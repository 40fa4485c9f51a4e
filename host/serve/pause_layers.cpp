#include "host/serve/pause_layers.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

namespace slipstick {
namespace {

constexpr int kLayerMax = 1'000'000;

}  // namespace

Result<std::vector<int>> pause_layers(const nlohmann::json& json) {
  const auto wrong = [] {
    return fail(
        ErrorCode::kInput,
        fmt::format("layers: must be an array of at most {} numbers of layers, from 0 to {}",
                    kPausesMax, kLayerMax));
  };
  if (!json.is_array() || json.size() > kPausesMax) return wrong();
  std::set<int> layers;
  for (const auto& layer : json) {
    const bool fits = layer.is_number_unsigned() && layer.get<std::uint64_t>() <= kLayerMax;
    if (!fits) return wrong();
    layers.insert(layer.get<int>());
  }
  return std::vector<int>(layers.begin(), layers.end());
}

std::vector<int> pauses_of(const StoredJob& job) {
  const auto layers = pause_layers(nlohmann::json::parse(job.pauses, nullptr, false));
  return layers.value_or(std::vector<int>());
}

}  // namespace slipstick
