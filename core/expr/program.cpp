#include "core/expr/program.h"

#include <limits>

#include "core/base/check.h"
#include "core/expr/specialize.h"

namespace slipstick {
namespace {

// Instructions with a register for every step of the tape.
class Writer {
 public:
  explicit Writer(const Tape& tape) : tape_(tape), register_of_(tape.steps.size()) {
    instructions.reserve(tape.steps.size());
    for (std::size_t i = 0; i < tape.steps.size(); ++i) register_of_[i] = write(i);
  }

  std::vector<Instruction> instructions;
  std::vector<double> constants;
  [[nodiscard]] std::uint32_t result() const { return register_of_.back(); }
  [[nodiscard]] std::uint32_t registers() const { return next_; }

 private:
  std::uint32_t write(std::size_t i) {
    const Tape::Step& step = tape_.steps[i];
    SLIPSTICK_CHECK(step.op != Op::kZ);
    if (step.op == Op::kX) return kRegisterX;
    if (step.op == Op::kY) return kRegisterY;
    const std::uint32_t out = next_++;
    instructions.push_back(instruction(step, out));
    return out;
  }

  Instruction instruction(const Tape::Step& step, std::uint32_t out) {
    if (step.op == Op::kConstant) return constant_instruction(out, step.value);
    const std::uint32_t a = register_of_[step.a];
    if (!is_binary(step.op)) return {code_of(step.op), out, a, 0};
    const std::uint32_t b = register_of_[step.b];
    const Tape::Step &left = tape_.steps[step.a], &right = tape_.steps[step.b];
    if (right.op == Op::kConstant) {
      const bool least = right.value == std::numeric_limits<double>::denorm_min();
      const Code add = least ? Code::kAddLeast : Code::kAddConstant;
      if (step.op == Op::kAdd) return {add, out, a, constant(right.value)};
      if (step.op == Op::kSubtract) return {Code::kAddConstant, out, a, constant(-right.value)};
      if (step.op == Op::kMultiply) return {Code::kScale, out, a, constant(right.value)};
    }
    if (left.op == Op::kConstant) {
      if (step.op == Op::kAdd) return {Code::kAddConstant, out, b, constant(left.value)};
      if (step.op == Op::kSubtract) return {Code::kConstantMinus, out, b, constant(left.value)};
      if (step.op == Op::kMultiply) return {Code::kScale, out, b, constant(left.value)};
    }
    return {code_of(step.op), out, a, b};
  }

  std::uint32_t constant(double value) {
    constants.push_back(value);
    return static_cast<std::uint32_t>(constants.size() - 1);
  }

  const Tape& tape_;
  std::vector<std::uint32_t> register_of_;
  std::uint32_t next_ = 2;
};

}  // namespace

Program::Program(const Tape& tape) {
  Writer writer(tape);
  const Listing wide{writer.instructions, writer.result(), writer.registers()};
  BoxNotes none;
  none.prepare(writer.instructions.size());
  std::vector<Instruction> room(writer.instructions.size());
  const Listing narrow = Specializer().specialize(wide, none, 0, Demand::kValue, room);
  instructions_.assign(narrow.instructions.begin(), narrow.instructions.end());
  constants_ = std::move(writer.constants);
  result_ = narrow.result;
  registers_ = narrow.registers;
}

}  // namespace slipstick
