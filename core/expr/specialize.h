#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/expr/program.h"

namespace slipstick {

/// How many boxes are bounded together.
inline constexpr std::size_t kBoxesMax = 16;

/// For one min or max, a bit a box: which operand alone gives the value there, and which one alone
/// gives the sign of it. Nothing is said of an operand that may be NaN and would be left out.
struct Choice {
  std::uint16_t value_is_a = 0;
  std::uint16_t value_is_b = 0;
  std::uint16_t sign_is_a = 0;
  std::uint16_t sign_is_b = 0;
};

/// What of the result must be kept: its bits, or only whether it is <= 0, > 0 or NaN.
enum class Demand : std::uint8_t { kNothing, kSign, kValue };

/// Shortens listings to what counts in one box, registers given out anew, in one pass from the last
/// instruction to the first. Keeps its memory.
class Specializer {
 public:
  /// \param choices One for each instruction; those that are no min or max are not read.
  /// \param room At least as long as the listing; the shorter one is written to its end.
  [[nodiscard]] Listing specialize(const Listing& listing, std::span<const Choice> choices,
                                   std::size_t box, Demand demand, std::span<Instruction> room);

 private:
  // By what follows; its new register only where there is a demand.
  struct OldRegister {
    std::uint32_t number = 0;
    Demand demand = Demand::kNothing;
  };

  [[nodiscard]] std::uint32_t claimed(std::uint32_t old, Demand demand);
  void forward(const Instruction& step, std::uint32_t old, Demand demand);
  void keep(Instruction step, Demand demand);
  void release(std::uint32_t number) { free_[free_count_++] = number; }
  void emit(const Instruction& step) { room_[--first_] = step; }

  std::span<Instruction> room_;
  std::size_t first_ = 0;
  std::uint32_t registers_ = 0;
  std::vector<OldRegister> old_;
  std::vector<std::uint32_t> free_;  // new registers, the first `free_count_`
  std::size_t free_count_ = 0;
};

}  // namespace slipstick
