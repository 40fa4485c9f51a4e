#include "sim/layer_series.h"

#include <algorithm>
#include <cmath>

namespace slipstick {

namespace {

double usual_height(std::span<const LayerTrace> layers, std::size_t i) {
  const double before = layers[i - 1].height;
  if (i + 1 == layers.size()) return before;
  const double after = layers[i + 1].height;
  return i == 1 ? after : std::max(before, after);
}

/// The middle of the cells that there are; 0 without.
double usual_cell(std::span<const LayerTrace> layers) {
  std::vector<double> cells;
  for (const LayerTrace& layer : layers) {
    if (layer.cell >= kCellMin) cells.push_back(layer.cell);
  }
  if (cells.empty()) return 0;
  const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(cells.size() / 2);
  std::nth_element(cells.begin(), middle, cells.end());
  return *middle;
}

/// The smaller of the cells before and after, of those that are cells; 0 without.
double next_cell(std::span<const LayerTrace> layers, std::size_t i) {
  const double before = i > 0 ? layers[i - 1].cell : 0;
  const double after = i + 1 < layers.size() ? layers[i + 1].cell : 0;
  const double smaller = std::min(before, after);
  return smaller >= kCellMin ? smaller : std::max(before, after);
}

}  // namespace

std::vector<LayerGap> gaps_in(std::span<const LayerTrace> layers) {
  std::vector<LayerGap> gaps;
  for (std::size_t i = 1; i < layers.size(); ++i) {
    const double usual = usual_height(layers, i);
    const double times = layers[i].height / usual;
    if (times > kOutOfSeries) gaps.push_back({i, static_cast<int>(std::lround(times)) - 1, usual});
  }
  return gaps;
}

std::vector<std::size_t> hollow_layers(std::span<const LayerTrace> layers) {
  const double usual = usual_cell(layers);
  std::vector<std::size_t> hollow;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double next = next_cell(layers, i);
    const double most = kOutOfSeries * std::max(usual, next);
    if (next >= kCellMin && layers[i].cell > most) hollow.push_back(i);
  }
  return hollow;
}

}  // namespace slipstick
