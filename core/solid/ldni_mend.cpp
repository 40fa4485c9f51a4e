#include "core/solid/ldni_mend.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

namespace slipstick {
namespace {

constexpr int kReach = 3;

class Mender {
 public:
  Mender(const LdniGrid& grid, std::span<const std::size_t> open) : grid_(grid), open_(open) {}

  [[nodiscard]] bool is_open(std::size_t ray) const {
    return std::ranges::binary_search(open_, ray);
  }

  // Ring by ring.
  [[nodiscard]] std::optional<std::size_t> neighbour(std::size_t ray) const {
    const int side = grid_.resolution();
    const int i = static_cast<int>(ray % static_cast<std::size_t>(side));
    const int j = static_cast<int>(ray / static_cast<std::size_t>(side));
    for (int ring = 1; ring <= kReach; ++ring) {
      for (int v = std::max(j - ring, 0); v <= std::min(j + ring, side - 1); ++v) {
        for (int u = std::max(i - ring, 0); u <= std::min(i + ring, side - 1); ++u) {
          if (std::max(std::abs(u - i), std::abs(v - j)) != ring) continue;
          if (const std::size_t other = grid_.ray(u, v); !is_open(other)) return other;
        }
      }
    }
    return {};
  }

 private:
  const LdniGrid& grid_;
  std::span<const std::size_t> open_;
};

}  // namespace

LdniMended mend(LdniRays& rays, const LdniGrid& grid, std::span<const std::size_t> open) {
  LdniMended result;
  if (open.empty()) return result;
  const Mender mender(grid, open);
  LdniRays mended;
  mended.first.reserve(rays.first.size());
  mended.samples.reserve(rays.samples.size());
  for (std::size_t ray = 0; ray < rays.size(); ++ray) {
    std::optional<std::size_t> from = ray;
    if (mender.is_open(ray)) {
      from = mender.neighbour(ray);
      ++(from ? result.copied : result.lost);
    }
    if (from) {
      const auto samples = rays.of(*from);
      mended.samples.insert(mended.samples.end(), samples.begin(), samples.end());
    }
    mended.end_ray();
  }
  rays = std::move(mended);
  return result;
}

}  // namespace slipstick
