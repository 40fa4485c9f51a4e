#include "core/contour/certify_events.h"

#include <algorithm>
#include <tuple>

#include "core/contour/ledger_runs.h"

namespace slipstick {
namespace {

bool before(const EventSquare& a, const EventSquare& b) {
  return std::tie(a.row, a.column) < std::tie(b.row, b.column);
}

// Joins each square with those of the four neighbours before it that are there.
void join_neighbours(const std::vector<EventSquare>& squares, DisjointSets& sets) {
  constexpr int kBefore[4][2] = {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (std::size_t i = 0; i < squares.size(); ++i) {
    for (const auto& [dx, dy] : kBefore) {
      const EventSquare wanted{squares[i].column + dx, squares[i].row + dy, 0, 0};
      const auto at = std::lower_bound(squares.begin(), squares.end(), wanted, before);
      if (at == squares.end() || before(wanted, *at)) continue;
      sets.join(i, static_cast<std::size_t>(at - squares.begin()));
    }
  }
}

}  // namespace

std::vector<SlabEvent> merged(std::vector<EventSquare> squares, SlabEvent::Kind kind,
                              const SliceGrid& grid) {
  std::sort(squares.begin(), squares.end(), before);
  DisjointSets sets(squares.size());
  join_neighbours(squares, sets);
  std::vector<SlabEvent> events;
  std::vector<std::size_t> event_of(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const EventSquare& s = squares[i];
    // The first square of a set stands for it.
    if (sets.find(i) == i) {
      event_of[i] = events.size();
      events.push_back({kind, {}});
    }
    Box3& box = events[event_of[sets.find(i)]].box;
    box = box.with({grid.node_x(s.column), grid.node_y(s.row), s.low})
              .with({grid.node_x(s.column + 1), grid.node_y(s.row + 1), s.high});
  }
  return events;
}

}  // namespace slipstick
