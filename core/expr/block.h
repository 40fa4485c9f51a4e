#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/expr/block_kernels.h"

namespace slipstick {

/// Registers for blocks of points or boxes; keeps its memory from call to call. For one thread.
class BlockRegisters {
 public:
  /// \pre `size` is a multiple of 8.
  [[nodiscard]] double* prepare(std::size_t registers, std::size_t size);

 private:
  struct alignas(64) Line {
    std::array<double, 8> lanes;
  };
  std::vector<Line> lines_;
};

/// Boxes in the plane that are bounded together.
struct BoxBatch {
  std::array<double, kBoxesMax> x_low{}, x_high{}, y_low{}, y_high{};
  std::size_t count = 0;
};

/// What is known of f in each of the boxes, a bit a box; of its sign nothing where it may be NaN.
struct BoxVerdict {
  std::uint16_t at_most_zero = 0;
  std::uint16_t above_zero = 0;
  std::uint16_t undefined = 0;  ///< Where f may be NaN.
};

/// f at the points. \pre As many xs as ys, at most `kBlockPoints`.
/// \return As many values, good until the registers are used again.
[[nodiscard]] std::span<const double> evaluate(const Listing& listing, const Program& program,
                                               std::span<const double> xs,
                                               std::span<const double> ys,
                                               BlockRegisters& registers);

/// \param notes Taken down for `Specializer`.
[[nodiscard]] BoxVerdict bound(const Listing& listing, const Program& program,
                               const BoxBatch& boxes, BlockRegisters& registers, BoxNotes& notes);

}  // namespace slipstick
