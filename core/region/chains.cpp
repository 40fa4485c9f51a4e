#include "core/region/chains.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace slipstick {
namespace {

class Tracker {
 public:
  Tracker(const BitImage& thin, const BitImage& kept) : thin_(thin), kept_(kept) {}

  std::vector<Chain> run() {
    const std::vector<Node> nodes = line_nodes();
    for (const Node n : nodes) {
      for (const Node m : beside(n)) {
        if (!is_line(m) && !walked(m, n)) add_open(walk(m, n));
      }
    }
    for (const Node n : nodes) {
      if (beside(n).size() != 2) follow_all(n);
    }
    for (const Node n : nodes) {  // what is left are closed lines
      for (const Node next : beside(n)) {
        if (!walked(n, next)) add_closed(walk(n, next));
      }
    }
    return std::move(chains_);
  }

 private:
  bool is_line(Node n) const { return at(n) && !kept_.at(n.column, n.row); }
  bool at(Node n) const { return thin_.at(n.column, n.row); }

  std::vector<Node> line_nodes() const {
    std::vector<Node> nodes;
    for (int row = 0; row < thin_.rows(); ++row) {
      for (int column = 0; column < thin_.columns(); ++column) {
        if (is_line({column, row})) nodes.push_back({column, row});
      }
    }
    return nodes;
  }

  std::vector<Node> beside(Node n) const {
    std::vector<Node> result;
    for (const auto& [dx, dy] : kSides) {
      const Node m{n.column + dx, n.row + dy};
      if (at(m)) result.push_back(m);
    }
    for (const auto& [dx, dy] : kCorners) {
      const Node m{n.column + dx, n.row + dy};
      if (at(m) && !at({m.column, n.row}) && !at({n.column, m.row})) result.push_back(m);
    }
    return result;
  }

  void follow_all(Node n) {
    const auto next = beside(n);
    if (next.empty()) chains_.push_back({{n}, false, false});
    for (const Node m : next) {
      if (!walked(n, m)) add_open(walk(n, m));
    }
  }

  // From n over m on, to the next node that is no plain part of a line, or back to n.
  std::vector<Node> walk(Node n, Node m) {
    std::vector<Node> nodes{n, m};
    mark(n, m);
    while (is_line(m) && !(m == nodes.front())) {
      const auto around = beside(m);
      if (around.size() != 2) break;
      const Node before = nodes[nodes.size() - 2];
      const Node next = around[0] == before ? around[1] : around[0];
      mark(m, next);
      nodes.push_back(next);
      m = next;
    }
    return nodes;
  }

  bool ends_freely(Node n) const { return is_line(n) && beside(n).size() == 1; }

  void add_open(std::vector<Node> nodes) {
    if (nodes.size() > 2 && nodes.front() == nodes.back()) return add_closed(std::move(nodes));
    if (ends_freely(nodes.front())) std::reverse(nodes.begin(), nodes.end());
    const bool is_spur = ends_freely(nodes.back()) && !ends_freely(nodes.front());
    chains_.push_back({std::move(nodes), false, is_spur});
  }

  void add_closed(std::vector<Node> nodes) {
    nodes.pop_back();
    chains_.push_back({std::move(nodes), true, false});
  }

  using Step = std::array<int, 4>;
  static Step key(Node a, Node b) {
    if (std::pair(b.row, b.column) < std::pair(a.row, a.column)) std::swap(a, b);
    return {a.column, a.row, b.column, b.row};
  }
  void mark(Node a, Node b) { walked_.insert(key(a, b)); }
  bool walked(Node a, Node b) const { return walked_.contains(key(a, b)); }

  static constexpr std::array<std::pair<int, int>, 4> kSides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  static constexpr std::array<std::pair<int, int>, 4> kCorners{
      {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

  const BitImage& thin_;
  const BitImage& kept_;
  std::vector<Chain> chains_;
  std::set<Step> walked_;  // steps between neighbouring nodes
};

}  // namespace

std::vector<Chain> chains_of(const BitImage& thin, const BitImage& kept) {
  return Tracker(thin, kept).run();
}

}  // namespace slipstick
