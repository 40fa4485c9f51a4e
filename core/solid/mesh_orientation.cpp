#include "core/solid/mesh_orientation.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace slipstick {
namespace {

struct Side {
  std::uint64_t edge;
  std::uint32_t triangle;
  bool upwards;  // Runs from the lower vertex number to the higher one.
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = mesh.triangles[k][i], to = mesh.triangles[k][(i + 1) % 3];
      const auto [low, high] = std::minmax(from, to);
      sides.push_back({(std::uint64_t{low} << 32) | high, k, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.edge, a.triangle) < std::pair(b.edge, b.triangle);
  });
  return sides;
}

// Calls `visit(first, end)` for the sides of each edge.
template <typename Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].edge == sides[first].edge) ++end;
    visit(first, end);
  }
}

std::int64_t unbalanced_edges(const std::vector<Side>& sides) {
  std::int64_t count = 0;
  for_each_edge(sides, [&](std::size_t first, std::size_t end) {
    std::int64_t sum = 0;
    for (std::size_t i = first; i < end; ++i) sum += sides[i].upwards ? 1 : -1;
    if (sum != 0) ++count;
  });
  return count;
}

struct Neighbour {
  std::uint32_t triangle;
  bool agrees;
};

// At most one neighbour across each side.
std::vector<std::vector<Neighbour>> neighbours(const std::vector<Side>& sides, std::size_t count) {
  std::vector<std::vector<Neighbour>> result(count);
  for_each_edge(sides, [&](std::size_t first, std::size_t end) {
    if (end - first != 2) return;
    const Side &a = sides[first], &b = sides[first + 1];
    const bool agrees = a.upwards != b.upwards;
    result[a.triangle].push_back({b.triangle, agrees});
    result[b.triangle].push_back({a.triangle, agrees});
  });
  return result;
}

std::int64_t turn_minorities(TriangleMesh& mesh, const std::vector<Side>& sides) {
  const auto adjacent = neighbours(sides, mesh.triangles.size());
  enum : std::uint8_t { kUnseen, kKept, kTurned };
  std::vector<std::uint8_t> state(mesh.triangles.size(), kUnseen);
  std::int64_t turned = 0;
  for (std::uint32_t seed = 0; seed < state.size(); ++seed) {
    if (state[seed] != kUnseen) continue;
    std::vector<std::uint32_t> part{seed};
    state[seed] = kKept;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (const auto& [next, agrees] : adjacent[part[i]]) {
        if (state[next] != kUnseen) continue;
        const bool keep = (state[part[i]] == kKept) == agrees;
        state[next] = keep ? kKept : kTurned;
        part.push_back(next);
      }
    }
    const auto kept =
        std::count_if(part.begin(), part.end(), [&](std::uint32_t t) { return state[t] == kKept; });
    const auto minority = 2 * kept < std::ssize(part) ? kKept : kTurned;
    for (const std::uint32_t t : part) {
      if (state[t] != minority) continue;
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      ++turned;
    }
  }
  return turned;
}

// The mesh with one triangle, the first, of those with the same corners.
TriangleMesh without_copies(const TriangleMesh& mesh) {
  const auto corners = [&](std::uint32_t triangle) {
    TriangleMesh::Triangle t = mesh.triangles[triangle];
    std::sort(t.begin(), t.end());
    return t;
  };
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(corners(a), a) < std::pair(corners(b), b);
  });
  std::vector<bool> is_copy(order.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    is_copy[order[i]] = corners(order[i]) == corners(order[i - 1]);
  }
  TriangleMesh result{mesh.vertices, {}};
  for (std::size_t t = 0; t < order.size(); ++t) {
    if (!is_copy[t]) result.triangles.push_back(mesh.triangles[t]);
  }
  return result;
}

// Unless more edges would be unbalanced. \return How many.
std::int64_t leave_out_copies(TriangleMesh& mesh, std::int64_t unbalanced) {
  TriangleMesh single = without_copies(mesh);
  const auto copies = std::ssize(mesh.triangles) - std::ssize(single.triangles);
  if (copies == 0 || unbalanced_edges(sorted_sides(single)) > unbalanced) return 0;
  mesh = std::move(single);
  return copies;
}

}  // namespace

Orientation orient(TriangleMesh& mesh) {
  Orientation result;
  result.unbalanced = unbalanced_edges(sorted_sides(mesh));
  if (result.unbalanced == 0) return result;
  result.copies = leave_out_copies(mesh, result.unbalanced);
  result.turned = turn_minorities(mesh, sorted_sides(mesh));
  result.unbalanced = unbalanced_edges(sorted_sides(mesh));
  return result;
}

}  // namespace slipstick
