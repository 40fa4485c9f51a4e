#include "tests/support/stacks.h"

#include <array>
#include <cstdlib>

#include "tests/support/images.h"

namespace slipstick::test {
namespace {

// The stack as a block of voxels with one layer of void all around.
class Voxels {
 public:
  explicit Voxels(const Stack& stack)
      : nx_(stack[0].columns() + 2),
        ny_(stack[0].rows() + 2),
        nz_(static_cast<int>(stack.size()) + 2) {
    cells_.assign(static_cast<std::size_t>(nx_ * ny_ * nz_), 0);
    for (int z = 1; z < nz_ - 1; ++z) {
      for (int y = 1; y < ny_ - 1; ++y) {
        for (int x = 1; x < nx_ - 1; ++x) {
          cells_[index(x, y, z)] = stack[static_cast<std::size_t>(z - 1)].at(x - 1, y - 1) ? 1 : 0;
        }
      }
    }
  }

  [[nodiscard]] bool within(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < nx_ && y < ny_ && z < nz_;
  }
  [[nodiscard]] bool at(int x, int y, int z) const {
    return within(x, y, z) && cells_[index(x, y, z)] != 0;
  }
  [[nodiscard]] int components(bool inside, bool by_faces) const;
  [[nodiscard]] int euler(bool closed) const;

 private:
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * ny_ + y) * nx_ + x);
  }
  void flood(std::array<int, 3> from, bool inside, bool by_faces, std::vector<char>& seen) const;

  int nx_, ny_, nz_;
  std::vector<char> cells_;
};

void Voxels::flood(std::array<int, 3> from, bool inside, bool by_faces,
                   std::vector<char>& seen) const {
  std::vector<std::array<int, 3>> todo{from};
  seen[index(from[0], from[1], from[2])] = 1;
  while (!todo.empty()) {
    const auto [x, y, z] = todo.back();
    todo.pop_back();
    for (int step = 0; step < 27; ++step) {
      const int dx = step % 3 - 1, dy = step / 3 % 3 - 1, dz = step / 9 - 1;
      if (by_faces && std::abs(dx) + std::abs(dy) + std::abs(dz) != 1) continue;
      if (!within(x + dx, y + dy, z + dz) || at(x + dx, y + dy, z + dz) != inside) continue;
      char& mark = seen[index(x + dx, y + dy, z + dz)];
      if (mark == 0) todo.push_back({x + dx, y + dy, z + dz});
      mark = 1;
    }
  }
}

int Voxels::components(bool inside, bool by_faces) const {
  std::vector<char> seen(cells_.size());
  int found = 0;
  for (int z = 0; z < nz_; ++z) {
    for (int y = 0; y < ny_; ++y) {
      for (int x = 0; x < nx_; ++x) {
        if (at(x, y, z) != inside || seen[index(x, y, z)] != 0) continue;
        ++found;
        flood({x, y, z}, inside, by_faces, seen);
      }
    }
  }
  return found;
}

// Every corner, edge, side and cube at doubled coordinates; odd ones run along an axis. A part
// belongs to a closed solid if any cube around it does, to an open one if all do.
int Voxels::euler(bool closed) const {
  int sum = 0;
  for (int w = 0; w < 2 * nz_; ++w) {
    for (int v = 0; v < 2 * ny_; ++v) {
      for (int u = 0; u < 2 * nx_; ++u) {
        int around = 0, inside = 0;
        for (int k = 0; k < 8; ++k) {
          const int i = k & 1, j = k >> 1 & 1, l = k >> 2;
          if ((u % 2 == 1 && i == 1) || (v % 2 == 1 && j == 1) || (w % 2 == 1 && l == 1)) continue;
          ++around;
          inside += at(u / 2 - i, v / 2 - j, w / 2 - l) ? 1 : 0;
        }
        const int sign = (u % 2 + v % 2 + w % 2) % 2 == 0 ? 1 : -1;
        if (closed ? inside > 0 : inside == around) sum += sign;
      }
    }
  }
  // Of an open solid the sum runs over the dual parts, which have the other parity in space.
  return closed ? sum : -sum;
}

}  // namespace

Stack stack_of(int n, const std::function<bool(Vec3)>& inside) {
  const auto middle = [n](int i) { return (2.0 * i + 1) / n - 1; };
  Stack stack;
  for (int k = 0; k < n; ++k) {
    BitImage image(small_grid(n, n));
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        if (inside({middle(i), middle(j), middle(k)})) image.set(i + 2, j + 2, true);
      }
    }
    stack.push_back(std::move(image));
  }
  return stack;
}

Topology ledger_of(const Stack& stack, Ambiguity ambiguity) {
  StackLedger ledger(ambiguity);
  for (const BitImage& image : stack) ledger.add(image);
  return ledger.topology();
}

Topology flooded(const Stack& stack, Ambiguity ambiguity) {
  const bool closed = ambiguity == Ambiguity::kSolid;
  const Voxels voxels(stack);
  Topology t;
  t.components = voxels.components(true, !closed);
  t.cavities = voxels.components(false, closed) - 1;
  t.tunnels = t.components + t.cavities - voxels.euler(closed);
  return t;
}

}  // namespace slipstick::test
