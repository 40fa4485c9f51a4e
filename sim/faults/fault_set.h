#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/faults/fault.h"
#include "sim/faults/fault_spec.h"

namespace slipstick {

/// All that goes wrong with one printer; bytes go through one fault after the other.
class FaultSet {
 public:
  /// \param seed of all chance; each fault has its own from it.
  FaultSet(const std::vector<FaultSpec>& specs, std::uint64_t seed);

  [[nodiscard]] bool empty() const { return faults_.empty(); }
  void see(Printer& printer);
  [[nodiscard]] std::optional<Moment> next_at() const;
  [[nodiscard]] std::string to_board(std::string bytes, Moment now);
  [[nodiscard]] std::string to_host(std::string text, Moment now);
  [[nodiscard]] Moment delay(Moment now) const;
  /// How often any of them did harm so far.
  [[nodiscard]] std::int64_t count() const;

 private:
  std::vector<std::unique_ptr<Fault>> faults_;
};

}  // namespace slipstick
