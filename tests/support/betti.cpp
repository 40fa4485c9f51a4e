#include "tests/support/betti.h"

#include <array>
#include <vector>

namespace slipstick::test {
namespace {

// The stack within a margin of one node.
class Voxels {
 public:
  explicit Voxels(std::span<const BitImage> stack)
      : nx_(stack[0].columns() + 2),
        ny_(stack[0].rows() + 2),
        nz_(static_cast<int>(stack.size()) + 2),
        inside_(index(0, 0, nz_)) {
    for (int z = 0; z < nz_ - 2; ++z) {
      for (int y = 0; y < ny_ - 2; ++y) {
        for (int x = 0; x < nx_ - 2; ++x) {
          inside_[index(x + 1, y + 1, z + 1)] = stack[static_cast<std::size_t>(z)].at(x, y) ? 1 : 0;
        }
      }
    }
  }

  int components(bool inside) const {
    std::vector<char> seen(inside_.size());
    int found = 0;
    for (std::size_t start = 0; start < inside_.size(); ++start) {
      if ((inside_[start] != 0) != inside || seen[start] != 0) continue;
      ++found;
      flood(start, seen);
    }
    return found;
  }

  // Vertices - edges + squares - cubes of the inside voxels seen as points.
  int euler() const {
    int sum = 0;
    for (int z = 0; z < nz_ - 1; ++z) {
      for (int y = 0; y < ny_ - 1; ++y) {
        for (int x = 0; x < nx_ - 1; ++x) sum += euler_at(x, y, z);
      }
    }
    return sum;
  }

 private:
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny_) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nx_) +
           static_cast<std::size_t>(x);
  }

  // What the cells whose lowest corner is here add.
  int euler_at(int x, int y, int z) const {
    const auto in = [&](int dx, int dy, int dz) { return inside_[index(x + dx, y + dy, z + dz)]; };
    if (in(0, 0, 0) == 0) return 0;
    const int a = in(1, 0, 0), b = in(0, 1, 0), c = in(0, 0, 1);
    const int ab = a & b & in(1, 1, 0), bc = b & c & in(0, 1, 1), ca = c & a & in(1, 0, 1);
    return 1 - a - b - c + ab + bc + ca - (ab & bc & ca & in(1, 1, 1));
  }

  void flood(std::size_t start, std::vector<char>& seen) const {
    const bool inside = inside_[start] != 0;
    std::vector<std::size_t> todo{start};
    seen[start] = 1;
    while (!todo.empty()) {
      const std::size_t at = todo.back();
      todo.pop_back();
      const auto row = static_cast<std::size_t>(nx_), plane = row * static_cast<std::size_t>(ny_);
      const int x = static_cast<int>(at % row), y = static_cast<int>(at / row) % ny_,
                z = static_cast<int>(at / plane);
      for (int i = 0; i < 27; ++i) {
        const int dx = i % 3 - 1, dy = i / 3 % 3 - 1, dz = i / 9 - 1;
        if (inside && dx * dx + dy * dy + dz * dz != 1) continue;
        const int u = x + dx, v = y + dy, w = z + dz;
        if (u < 0 || v < 0 || w < 0 || u >= nx_ || v >= ny_ || w >= nz_) continue;
        const std::size_t next = index(u, v, w);
        if ((inside_[next] != 0) != inside || seen[next] != 0) continue;
        seen[next] = 1;
        todo.push_back(next);
      }
    }
  }

  int nx_;
  int ny_;
  int nz_;
  std::vector<char> inside_;
};

}  // namespace

Betti betti_of(std::span<const BitImage> stack) {
  const Voxels voxels(stack);
  Betti betti;
  betti.components = voxels.components(true);
  betti.cavities = voxels.components(false) - 1;
  betti.tunnels = betti.components + betti.cavities - voxels.euler();
  return betti;
}

}  // namespace slipstick::test
