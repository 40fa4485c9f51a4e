#include "host/kept_images.h"

#include <algorithm>

#include "core/region/islands.h"

namespace slipstick {
namespace {

// A list that is longer by one begins a few layers below those that are made.
constexpr int kKept = 8;

int first_layer(std::span<const CancelledObject> cancelled) {
  return std::ranges::min(cancelled, {}, &CancelledObject::layer).layer;
}

}  // namespace

Result<KeptImages::Image> KeptImages::image(int layer, std::span<const CancelledObject> cancelled) {
  auto whole = images_.image(layer);
  if (!whole || cancelled.empty() || layer < first_layer(cancelled) || layer >= layers_)
    return whole;
  const std::lock_guard lock(mutex_);
  const auto out = left_out(chain_of(cancelled), layer);
  if (!out) return fail(out.error());
  return std::make_shared<const BitImage>(**whole - **out);
}

// A longer list leaves out what the shorter one did, up to what it names more. \pre The lock is
// held.
KeptImages::Chain& KeptImages::chain_of(std::span<const CancelledObject> cancelled) {
  Chain& chain = chains_[cancelled.size()];
  if (!chain.cancelled.empty()) return chain;
  chain.cancelled.assign(cancelled.begin(), cancelled.end());
  const auto shorter = chains_.find(cancelled.size() - 1);
  if (shorter == chains_.end()) return chain;
  const auto& known = shorter->second.left_out;
  chain.left_out.insert(known.begin(), known.lower_bound(cancelled.back().layer));
  return chain;
}

void KeptImages::forget_below(int layer) {
  const std::lock_guard lock(mutex_);
  for (auto& [count, chain] : chains_) {
    chain.left_out.erase(chain.left_out.begin(), chain.left_out.lower_bound(layer - kKept));
  }
}

// \pre The lock is held.
Result<KeptImages::Image> KeptImages::left_out(Chain& chain, int layer) {
  const int first = first_layer(chain.cancelled);
  auto known = chain.left_out.upper_bound(layer);
  int next = first;
  Image below = std::make_shared<const BitImage>(grid_);
  if (known != chain.left_out.begin()) {
    --known;
    next = known->first + 1;
    below = known->second;
  }
  for (; next <= layer; ++next) {
    auto out = step(chain, next, below);
    if (!out) return fail(out.error());
    below = std::make_shared<const BitImage>(*std::move(out));
    chain.left_out[next] = below;
  }
  return below;
}

Result<BitImage> KeptImages::step(const Chain& chain, int layer, const Image& below) {
  const auto whole = images_.image(layer);
  if (!whole) return fail(whole.error());
  BitImage out(grid_);
  if (below->any()) {
    const auto under = images_.image(layer - 1);
    if (!under) return fail(under.error());
    out = standing_on(**whole, **under, *below);
  }
  for (const CancelledObject& object : chain.cancelled) {
    if (object.layer == layer) out |= island_at(**whole, object.x, object.y);
  }
  return out;
}

}  // namespace slipstick
