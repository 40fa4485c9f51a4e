#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/contour/corridor.h"
#include "core/contour/frechet.h"
#include "core/contour/prefix_moments.h"
#include "core/contour/simplify.h"
#include "core/contour/wedge.h"

namespace slipstick {

/// The fewest edges through the windows of one loop, cut open at a vertex, from candidate to
/// candidate; among the fewest the least distortion. A dynamic programme over (stick, candidate),
/// edge by edge. Keeps its memory from loop to loop.
///
/// What one edge more reaches is looked for from the farthest `kOriginSticks` sticks that were
/// reached with the last one. Looking from all of them would be exact, but costs the square of its
/// length on a straight side, and gains little: over the nine subjects of the table of targets the
/// mean number of edges, against the paper's pipeline, was 0.44 from 4 sticks and 0.43 from 48.
class EdgeSearch {
 public:
  static constexpr std::size_t kOriginSticks = 5;

  explicit EdgeSearch(Candidates candidates) : candidates_(candidates) {}

  /// The cheapest way once round from the own place of stick `start` and back to it.
  void run(const Corridor& corridor, std::size_t start);

  /// The way found, ascending by index.
  [[nodiscard]] const std::vector<Kept>& kept() const { return kept_; }
  /// Of its edges, the largest D' (paper, equation 5), in cubic cells.
  [[nodiscard]] double worst_distortion() const { return worst_distortion_; }

 private:
  static constexpr std::size_t kCandidates = Corridor::kCandidates;
  static constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();
  using Points = std::array<Ray<double>, kCandidates>;

  struct Best {
    std::int32_t edges = kNever;
    std::uint32_t from = 0;  // (stick, candidate) as one number
    double distortion = 0;
  };
  // Where is being looked from.
  struct Origin {
    std::size_t stick;
    std::size_t candidate;
    Ray<double> point;
    Best best;
  };

  void prepare(const Corridor& corridor, std::size_t start);
  void look_from_all();
  template <Candidates kUsed>
  void look_from(std::uint32_t state);
  template <Candidates kUsed, typename Number>
  [[nodiscard]] bool look(const Origin& origin, Wedge<Number>& wedge, std::size_t first,
                          std::size_t end);
  [[nodiscard]] static bool improves(const Best& origin, const Best& to);
  void reach(const Origin& origin, std::size_t stick, std::size_t candidate);
  void collect(const Corridor& corridor);

  Candidates candidates_;
  std::size_t start_ = 0;
  std::size_t n_ = 0;
  PrefixMoments moments_;
  std::vector<Points> points_;  // from the start once round, relative to it
  std::vector<Best> best_;
  std::vector<std::uint32_t> reached_;  // with the last edge
  std::vector<std::uint32_t> next_;     // with one more
  std::vector<Kept> kept_;
  double worst_distortion_ = 0;
};

}  // namespace slipstick
