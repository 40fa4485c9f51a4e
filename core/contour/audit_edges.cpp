#include "core/contour/audit_edges.h"

#include <cmath>

namespace slipstick::audit_exact {
namespace {

// Buckets a side, at most: enough that a bucket of a dense layer holds a few edges.
constexpr std::int64_t kBucketsMax = 1024;

std::vector<Edge> edges_of(const std::vector<AuditLoop>& loops) {
  std::vector<Edge> edges;
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    const auto& points = loops[loop].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t next = (i + 1) % points.size();
      edges.push_back({point(points[i]), point(points[next]), loop, i, next});
    }
  }
  return edges;
}

}  // namespace

EdgeBuckets::EdgeBuckets(const std::vector<AuditLoop>& loops) : edges_(edges_of(loops)) {
  if (edges_.empty()) {
    buckets_.resize(1);
    by_row_.resize(1);
    return;
  }
  low_ = high_ = edges_[0].from;
  for (const Edge& e : edges_) {
    low_ = {std::min(low_.x, e.from.x), std::min(low_.y, e.from.y)};
    high_ = {std::max(high_.x, e.from.x), std::max(high_.y, e.from.y)};
  }
  const std::int64_t side = std::max(high_.x - low_.x, high_.y - low_.y) + 1;
  const auto wanted = static_cast<std::int64_t>(std::sqrt(static_cast<double>(edges_.size()))) + 1;
  bucket_ = side / std::min(wanted, kBucketsMax) + 1;
  columns_ = column_of(high_.x) + 1;
  rows_ = row_of(high_.y) + 1;
  buckets_.resize(columns_ * rows_);
  by_row_.resize(rows_);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Window w = window(edges_[i]);
    for (std::size_t row = w.bottom; row <= w.top; ++row) {
      by_row_[row].push_back(i);
      for (std::size_t c = w.left; c <= w.right; ++c) buckets_[row * columns_ + c].push_back(i);
    }
  }
}

void EdgeBuckets::for_each_close_pair(
    const std::function<void(const Edge&, const Edge&)>& visit) const {
  for (const auto& bucket : buckets_) {
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      for (std::size_t j = i + 1; j < bucket.size(); ++j) {
        visit(edges_[bucket[i]], edges_[bucket[j]]);
      }
    }
  }
}

void EdgeBuckets::for_each_in_row_of(std::int64_t y,
                                     const std::function<void(const Edge&)>& visit) const {
  if (edges_.empty() || y < low_.y || y > high_.y) return;
  for (const std::uint32_t i : by_row_[row_of(y)]) visit(edges_[i]);
}

EdgeBuckets::Window EdgeBuckets::window(const Edge& e) const {
  return {column_of(std::min(e.from.x, e.to.x)), column_of(std::max(e.from.x, e.to.x)),
          row_of(std::min(e.from.y, e.to.y)), row_of(std::max(e.from.y, e.to.y))};
}

std::size_t EdgeBuckets::column_of(std::int64_t x) const {
  return static_cast<std::size_t>((x - low_.x) / bucket_);
}

std::size_t EdgeBuckets::row_of(std::int64_t y) const {
  return static_cast<std::size_t>((y - low_.y) / bucket_);
}

}  // namespace slipstick::audit_exact
