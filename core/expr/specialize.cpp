#include "core/expr/specialize.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/check.h"

namespace slipstick {
namespace {

constexpr std::uint32_t kFirstFree = 2;  // behind x and y

bool reads_a(Code code) {
  return code != code_of(Op::kConstant);
}

bool reads_b(Code code) {
  return code < Code::kCopy && is_binary(op_of(code));
}

bool is_choice(Code code) {
  return code == code_of(Op::kMin) || code == code_of(Op::kMax);
}

// The sign of the result is that of the operands, or of one of them.
bool passes_sign(Code code) {
  return is_choice(code) || code == code_of(Op::kNegate) || code == Code::kAddLeast;
}

// The operand that stands for the whole, if one does.
std::optional<std::uint32_t> stand_in(const Instruction& step, const Choice& choice,
                                      std::size_t box, Demand demand) {
  if (step.code == Code::kCopy) return step.a;
  if (!is_choice(step.code)) return {};
  const auto has = [box](std::uint16_t mask) { return ((mask >> box) & 1) != 0; };
  const bool sign = demand == Demand::kSign;
  if (has(choice.value_is_a) || (sign && has(choice.sign_is_a))) return step.a;
  if (has(choice.value_is_b) || (sign && has(choice.sign_is_b))) return step.b;
  return {};
}

}  // namespace

// The new register of an old one; a new one if nothing behind has asked for it.
std::uint32_t Specializer::claimed(std::uint32_t old, Demand demand) {
  if (old < kFirstFree) return old;
  OldRegister& r = old_[old];
  if (r.demand == Demand::kNothing) {
    r.number = free_count_ > 0 ? free_[--free_count_] : registers_++;
  }
  r.demand = std::max(r.demand, demand);
  return r.number;
}

// `old` takes the place of the step's result, or is copied to it if it has a place already.
void Specializer::forward(const Instruction& step, std::uint32_t old, Demand demand) {
  const std::uint32_t out = old_[step.out].number;
  if (old >= kFirstFree && old_[old].demand == Demand::kNothing) {
    old_[old] = {out, demand};
    return;
  }
  release(out);
  emit({Code::kCopy, out, claimed(old, demand), 0});
}

void Specializer::keep(Instruction step, Demand demand) {
  const Demand inner = passes_sign(step.code) ? demand : Demand::kValue;
  step.out = old_[step.out].number;
  release(step.out);
  if (reads_a(step.code)) step.a = claimed(step.a, inner);
  if (reads_b(step.code)) step.b = claimed(step.b, inner);
  emit(step);
}

Listing Specializer::specialize(const Listing& listing, const BoxNotes& notes, std::size_t box,
                                Demand demand, std::span<Instruction> room) {
  SLIPSTICK_DCHECK(room.size() >= listing.instructions.size());
  SLIPSTICK_DCHECK(notes.choices.size() >= listing.instructions.size());
  room_ = room;
  first_ = room.size();
  registers_ = kFirstFree;
  free_count_ = 0;
  old_.assign(listing.registers, {});
  free_.resize(std::max<std::size_t>(free_.size(), listing.registers));
  const std::uint32_t result = claimed(listing.result, demand);
  for (std::size_t i = listing.instructions.size(); i-- > 0;) {
    const Instruction& step = listing.instructions[i];
    const Demand wanted = std::exchange(old_[step.out].demand, Demand::kNothing);
    if (wanted == Demand::kNothing) continue;
    const Choice& choice = notes.choices[i];
    if (const auto stands = stand_in(step, choice, box, wanted)) {
      forward(step, *stands, wanted);
    } else if (rounds(step.code) && ((choice.settled >> box) & 1) != 0) {
      keep(constant_instruction(step.out, notes.settled[choice.values][box]), wanted);
    } else {
      keep(step, wanted);
    }
  }
  return {room.subspan(first_), result, registers_};
}

}  // namespace slipstick
