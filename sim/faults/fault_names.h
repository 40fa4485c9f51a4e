#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "sim/faults/fault_spec.h"

namespace slipstick {

/// What the value of a fault is.
enum class FaultValue : std::uint8_t {
  kNone,     ///< It happens once.
  kShare,    ///< Of bytes or lines, 0 to 1; it is there all the time, if no other is told.
  kSeconds,  ///< That it lasts, or that it takes.
  kWords,    ///< Text.
};

/// A fault by name.
struct FaultName {
  /// When a fault that happens once does so if nobody says: a moment drawn from the seed.
  static constexpr Moment kEarliest{5'000'000};
  static constexpr Moment kLatest{65'000'000};

  std::string_view name;
  FaultValue value;
  double usual;  ///< The value, if none is given.
  double most;
  std::string_view what;  ///< A sentence for a person.
  std::unique_ptr<Fault> (*make)(const FaultSpec& spec, const FaultWhen& when, std::uint64_t seed);
};

/// All there are, in the order of help.
[[nodiscard]] std::span<const FaultName> fault_names();
/// "a, b, c"
[[nodiscard]] std::string list_of_faults();
/// A table for a person: one fault a line.
[[nodiscard]] std::string help_on_faults();

/// The fault that `spec` names. \param seed of its chance.
[[nodiscard]] std::unique_ptr<Fault> make_fault(const FaultSpec& spec, std::uint64_t seed);

}  // namespace slipstick
