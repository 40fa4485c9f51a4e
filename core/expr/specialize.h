#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/expr/program.h"

namespace slipstick {

/// How many boxes are bounded together.
inline constexpr std::size_t kBoxesMax = 16;

/// For one min or max, a bit a box: which operand alone gives the value there, and which one alone
/// gives the sign of it. Nothing is said of an operand that may be NaN and would be left out.
/// For floor and its like: where the value is one, and which of the settled values it is.
struct Choice {
  std::uint16_t value_is_a = 0;
  std::uint16_t value_is_b = 0;
  std::uint16_t sign_is_a = 0;
  std::uint16_t sign_is_b = 0;
  std::uint16_t settled = 0;
  std::uint16_t values = 0;
};

/// So many are noted of a listing, as many as `Choice::values` can count.
inline constexpr std::size_t kSettledMax = 1 << 16;
/// A value for each box.
using SettledValues = std::array<double, kBoxesMax>;

/// What bounding a listing over boxes has told of its instructions. Keeps its memory.
struct BoxNotes {
  std::vector<Choice> choices;  ///< One an instruction; set for min, max and what rounds.
  std::vector<SettledValues> settled;

  void prepare(std::size_t instructions) {
    if (choices.size() < instructions) choices.resize(instructions);
    settled.clear();
  }
};

/// Whether the value is a whole number, so that it may well be the same all over a box.
[[nodiscard]] constexpr bool rounds(Code code) {
  return code >= code_of(Op::kFloor) && code <= code_of(Op::kRound);
}
static_assert(code_of(Op::kFloor) < code_of(Op::kCeil) && code_of(Op::kCeil) < code_of(Op::kRound));

/// What of the result must be kept: its bits, or only whether it is <= 0, > 0 or NaN.
enum class Demand : std::uint8_t { kNothing, kSign, kValue };

/// Shortens listings to what counts in one box, registers given out anew, in one pass from the last
/// instruction to the first. Keeps its memory.
class Specializer {
 public:
  /// \param notes Of this listing over boxes, of which `box` is one.
  /// \param room At least as long as the listing; the shorter one is written to its end.
  [[nodiscard]] Listing specialize(const Listing& listing, const BoxNotes& notes, std::size_t box,
                                   Demand demand, std::span<Instruction> room);

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
