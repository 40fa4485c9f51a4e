#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/expr/tape.h"

namespace slipstick {

/// What an instruction does: an `Op`, its value kept, or one of the three that save a register for
/// a constant.
enum class Code : std::uint8_t {
  kCopy = static_cast<std::uint8_t>(Op::kOr) + 1,
  kAddConstant,    ///< a + constants[b]; a - c, too, which is a + (-c) to the bit
  kAddLeast,       ///< The same with the least positive double: <= 0 where a < 0
  kConstantMinus,  ///< constants[b] - a
  kScale,          ///< a · constants[b]
};
[[nodiscard]] constexpr Code code_of(Op op) {
  return static_cast<Code>(op);
}
/// \pre `code` is below `kCopy`.
[[nodiscard]] constexpr Op op_of(Code code) {
  return static_cast<Op>(code);
}

struct Instruction {
  Code code;
  std::uint32_t out;  ///< A register.
  std::uint32_t a;    ///< A register; of a constant, half of its bits.
  std::uint32_t b;    ///< A register or the index of a constant; the other half of the bits.
};

/// Writes `value`.
[[nodiscard]] constexpr Instruction constant_instruction(std::uint32_t out, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return {static_cast<Code>(Op::kConstant), out, static_cast<std::uint32_t>(bits),
          static_cast<std::uint32_t>(bits >> 32)};
}
/// What it writes. \pre It is a constant.
[[nodiscard]] constexpr double constant_of(const Instruction& step) {
  return std::bit_cast<double>(std::uint64_t{step.b} << 32 | step.a);
}

/// Registers that hold the coordinates and are never written.
inline constexpr std::uint32_t kRegisterX = 0;
inline constexpr std::uint32_t kRegisterY = 1;

/// Instructions to be run in order, and where the result is then. Belongs to a `Program`.
struct Listing {
  std::span<const Instruction> instructions;
  std::uint32_t result = kRegisterX;
  std::uint32_t registers = 2;
};

/// An expression in a plane as instructions on few registers, for the vector kernels
/// (`core/expr/block.h`). Gives the bits of the tape.
class Program {
 public:
  /// \pre `tape` has no z (see `at_height`).
  explicit Program(const Tape& tape);

  [[nodiscard]] Listing listing() const { return {instructions_, result_, registers_}; }
  [[nodiscard]] std::span<const double> constants() const { return constants_; }

 private:
  std::vector<Instruction> instructions_;
  std::vector<double> constants_;
  std::uint32_t result_ = kRegisterX;
  std::uint32_t registers_ = 2;
};

}  // namespace slipstick
