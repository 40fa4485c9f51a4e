#include "core/expr/block.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace slipstick {

double* BlockRegisters::prepare(std::size_t registers, std::size_t size) {
  SLIPSTICK_DCHECK(size % 8 == 0);
  lines_.resize(std::max(lines_.size(), registers * size / 8));
  return lines_.data()->lanes.data();
}

std::span<const double> evaluate(const Listing& listing, const Program& program,
                                 std::span<const double> xs, std::span<const double> ys,
                                 BlockRegisters& registers) {
  SLIPSTICK_CHECK(xs.size() == ys.size() && xs.size() <= kBlockPoints);
  if (xs.empty()) return {};
  const std::size_t size = (xs.size() + 7) / 8 * 8;
  double* const values = registers.prepare(listing.registers, size);
  std::fill(std::copy(xs.begin(), xs.end(), values), values + size, xs.back());
  std::fill(std::copy(ys.begin(), ys.end(), values + size), values + 2 * size, ys.back());
  run_points({listing.instructions, program.constants().data(), values, size, size});
  return {values + listing.result * size, xs.size()};
}

BoxVerdict bound(const Listing& listing, const Program& program, const BoxBatch& boxes,
                 BlockRegisters& registers, BoxNotes& notes) {
  notes.prepare(listing.instructions.size());
  double* at = registers.prepare(listing.registers, 2 * kBoxesMax);
  double* const values = at;
  for (const auto* side : {&boxes.x_low, &boxes.x_high, &boxes.y_low, &boxes.y_high}) {
    at = std::copy(side->begin(), side->end(), at);
  }
  run_boxes({listing.instructions, program.constants().data(), values, boxes.count, notes});
  const double* const low = values + std::size_t{2} * listing.result * kBoxesMax;
  BoxVerdict verdict;
  for (std::size_t i = 0; i < boxes.count; ++i) {
    if (low[kBoxesMax + i] <= 0) verdict.at_most_zero |= static_cast<std::uint16_t>(1u << i);
    if (std::isnan(low[i])) verdict.undefined |= static_cast<std::uint16_t>(1u << i);
    if (low[i] > 0) verdict.above_zero |= static_cast<std::uint16_t>(1u << i);
  }
  return verdict;
}

}  // namespace slipstick
