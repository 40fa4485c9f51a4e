#include "core/solid/ldni_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slipstick {
namespace {

constexpr int kSide = LdniBlocks::kSide;
constexpr double kPerUnit = 1.0 / LdniGrid::kUnits;
// More than a sample's say, so that rounding cannot matter.
constexpr double kFar = kLdniShiftMax + kLdniReach + 1e-6;

double block_of(double widths) {
  return std::floor(widths / kSide);
}

std::size_t block_index(int side, const std::array<int, 3>& at) {
  const auto part = [](int c) { return static_cast<std::size_t>(c); };
  return (part(at[2]) * part(side) + part(at[1])) * part(side) + part(at[0]);
}

// Two bits of votes for inside, two for outside, and whether a sample has a say.
struct Votes {
  std::uint8_t inside : 2 = 0;
  std::uint8_t outside : 2 = 0;
  std::uint8_t disturbed : 1 = 0;
};

// The blocks along one bundle of rays.
class Column {
 public:
  explicit Column(int side) : side_(side), steps_(static_cast<std::size_t>(side) + 1) {}

  void begin() {
    std::ranges::fill(steps_, Step{});
    rays_ = 0;
  }

  void add(std::span<const LdniSample> ray) {
    ++rays_;
    int turn = 1;
    for (const LdniSample& sample : ray) {
      const double depth = sample.depth * kPerUnit;
      for (double b = block_of(depth - kFar); b <= block_of(depth + kFar); ++b) {
        if (b >= 0 && b < side_) steps_[static_cast<std::size_t>(b)].disturbed = true;
      }
      steps_[first_middle_from(depth)].rays += turn;
      turn = -turn;
    }
  }

  template <typename Visit>
  void end(Visit visit) const {
    int inside = 0;
    for (int b = 0; b < side_; ++b) {
      const Step& step = steps_[static_cast<std::size_t>(b)];
      inside += step.rays;
      visit(b, step.disturbed, inside == rays_, inside == 0);
    }
  }

 private:
  struct Step {
    int rays = 0;  // that go in before the middle of this block and not before that of the last
    bool disturbed = false;
  };

  // The first block whose middle lies at `depth` or beyond.
  [[nodiscard]] std::size_t first_middle_from(double depth) const {
    const double block = std::ceil((depth - 0.5 * kSide) / kSide);
    return static_cast<std::size_t>(std::clamp(block, 0.0, static_cast<double>(side_)));
  }

  int side_;
  int rays_ = 0;
  std::vector<Step> steps_;
};

// What the rays of all three axes say of each block.
class Poll {
 public:
  explicit Poll(const Ldni& ldni)
      : ldni_(ldni),
        resolution_(ldni.grid().resolution()),
        side_((resolution_ + kSide - 1) / kSide),
        column_(side_) {
    const auto side = static_cast<std::size_t>(side_);
    votes_.resize(side * side * side);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int v = 0; v < side_; ++v) {
        for (int u = 0; u < side_; ++u) ask(axis, u, v);
      }
    }
  }

  [[nodiscard]] std::vector<Cover> covers() const {
    std::vector<Cover> covers;
    covers.reserve(votes_.size());
    for (const Votes& v : votes_) covers.push_back(cover_of(v));
    return covers;
  }

 private:
  static Cover cover_of(const Votes& v) {
    if (v.disturbed != 0) return Cover::kMixed;
    if (v.inside >= 2) return Cover::kInside;
    return v.outside >= 2 ? Cover::kOutside : Cover::kMixed;
  }

  void ask(std::size_t axis, int u, int v) {
    column_.begin();
    for (int j = v * kSide; j <= std::min((v + 1) * kSide, resolution_ - 1); ++j) {
      for (int i = u * kSide; i <= std::min((u + 1) * kSide, resolution_ - 1); ++i) {
        column_.add(ldni_.axes()[axis].of(ldni_.grid().ray(i, j)));
      }
    }
    column_.end([&](int along, bool disturbed, bool all, bool none) {
      std::array<int, 3> at{};
      at[axis] = along;
      at[(axis + 1) % 3] = u;
      at[(axis + 2) % 3] = v;
      Votes& here = votes_[block_index(side_, at)];
      if (disturbed) here.disturbed = 1;
      if (all) ++here.inside;
      if (none) ++here.outside;
    });
  }

  const Ldni& ldni_;
  int resolution_;
  int side_;
  Column column_;
  std::vector<Votes> votes_;
};

}  // namespace

LdniBlocks::LdniBlocks(const Ldni& ldni)
    : resolution_(ldni.grid().resolution()),
      side_((resolution_ + kSide - 1) / kSide),
      covers_(Poll(ldni).covers()) {}

Cover LdniBlocks::cover(const LdniPoint& low, const LdniPoint& high) const {
  const double end = resolution_ - 1;
  std::array<int, 3> first{}, last{};
  bool beyond = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(low[k] <= end && high[k] >= 0)) return Cover::kOutside;
    beyond = beyond || low[k] < 0 || high[k] > end;
    first[k] = static_cast<int>(std::max(low[k], 0.0)) / kSide;
    last[k] = static_cast<int>(std::min(high[k], end)) / kSide;
  }
  const Cover cover = beyond ? Cover::kOutside : covers_[block_index(side_, first)];
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      for (int x = first[0]; x <= last[0]; ++x) {
        if (covers_[block_index(side_, {x, y, z})] != cover) return Cover::kMixed;
      }
    }
  }
  return cover;
}

}  // namespace slipstick
