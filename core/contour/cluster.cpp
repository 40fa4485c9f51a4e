#include "core/contour/cluster.h"

#include <functional>
#include <limits>
#include <optional>
#include <queue>

#include "core/base/check.h"
#include "core/contour/proxy.h"

namespace slipstick {
namespace {

constexpr int kRounds = 20;  // "20 iterations always can provide satisfactory results"
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

class Clustering {
 public:
  Clustering(std::span<const Vec2> points, Connection connection, std::size_t count)
      : points_(points),
        closed_(connection == Connection::kClosed),
        edges_(closed_ ? points.size() : points.size() - 1),
        owner_(edges_) {
    SLIPSTICK_CHECK(count >= 1 && count <= edges_);
    for (std::size_t i = 0; i < count; ++i) seeds_.push_back(i * edges_ / count);
  }

  std::vector<std::size_t> run() {
    for (const std::size_t seed : seeds_) {
      RegionMoments moments(points_[seed]);
      moments.add_edge(start(seed), end(seed));
      proxies_.push_back(moments.best_proxy());
    }
    grow();
    for (int round = 1; round < kRounds; ++round) {
      fit_proxies();
      const std::vector<std::size_t> before = seeds_;
      move_seeds();
      if (seeds_ == before) break;
      grow();
    }
    return first_edges();
  }

 private:
  struct Claim {
    double cost;
    std::size_t edge;
    std::size_t region;
    bool operator>(const Claim& other) const {
      if (cost != other.cost) return cost > other.cost;
      return edge != other.edge ? edge > other.edge : region > other.region;
    }
  };

  Vec2 start(std::size_t edge) const { return points_[edge]; }
  Vec2 end(std::size_t edge) const { return points_[edge + 1 < points_.size() ? edge + 1 : 0]; }
  std::optional<std::size_t> after(std::size_t edge) const {
    if (edge + 1 < edges_) return edge + 1;
    return closed_ ? std::optional<std::size_t>(0) : std::nullopt;
  }
  std::optional<std::size_t> before(std::size_t edge) const {
    if (edge > 0) return edge - 1;
    return closed_ ? std::optional(edges_ - 1) : std::nullopt;
  }

  void grow() {
    owner_.assign(edges_, kNobody);
    for (std::size_t region = 0; region < seeds_.size(); ++region) {
      owner_[seeds_[region]] = region;
    }
    for (std::size_t region = 0; region < seeds_.size(); ++region) {
      claim_beside(seeds_[region], region);
    }
    while (!queue_.empty()) {
      const Claim claim = queue_.top();
      queue_.pop();
      if (owner_[claim.edge] != kNobody) continue;
      owner_[claim.edge] = claim.region;
      claim_beside(claim.edge, claim.region);
    }
  }

  void claim_beside(std::size_t edge, std::size_t region) {
    for (const auto beside : {before(edge), after(edge)}) {
      if (!beside || owner_[*beside] != kNobody) continue;
      queue_.push({distortion(start(*beside), end(*beside), proxies_[region]), *beside, region});
    }
  }

  void fit_proxies() {
    std::vector<RegionMoments> moments;
    moments.reserve(seeds_.size());
    for (const std::size_t seed : seeds_) moments.emplace_back(points_[seed]);
    for (std::size_t edge = 0; edge < edges_; ++edge) {
      moments[owner_[edge]].add_edge(start(edge), end(edge));
    }
    for (std::size_t i = 0; i < proxies_.size(); ++i) proxies_[i] = moments[i].best_proxy();
  }

  void move_seeds() {
    std::vector<double> least(seeds_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t edge = 0; edge < edges_; ++edge) {
      const std::size_t region = owner_[edge];
      const double cost = distortion(start(edge), end(edge), proxies_[region]);
      if (cost < least[region]) {
        least[region] = cost;
        seeds_[region] = edge;
      }
    }
  }

  std::vector<std::size_t> first_edges() const {
    std::vector<std::size_t> first;
    for (std::size_t edge = 0; edge < edges_; ++edge) {
      const auto previous = before(edge);
      if (!previous || owner_[*previous] != owner_[edge]) first.push_back(edge);
    }
    if (first.empty()) first.push_back(0);  // one region, all the way round
    return first;
  }

  std::span<const Vec2> points_;
  bool closed_;
  std::size_t edges_;
  std::vector<std::size_t> owner_;  // region of each edge
  std::vector<std::size_t> seeds_;
  std::vector<Proxy> proxies_;
  std::priority_queue<Claim, std::vector<Claim>, std::greater<>> queue_;
};

}  // namespace

std::vector<std::size_t> cluster(std::span<const Vec2> points, Connection connection,
                                 std::size_t count) {
  return Clustering(points, connection, count).run();
}

}  // namespace slipstick
