#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "sim/faults/fault.h"
#include "sim/faults/fault_spec.h"

namespace slipstick {

/// All that goes wrong with one printer; bytes go through one fault after the other.
class FaultSet {
 public:
  /// \param seed of all chance; each fault has its own from it.
  FaultSet(const std::vector<FaultSpec>& specs, std::uint64_t seed);

  static constexpr std::size_t kMost = 64;

  /// One more. \return kInput if there are `kMost` that are not over.
  [[nodiscard]] Result<void> add(const FaultSpec& spec);
  /// Ends all of them.
  void mend(Printer& printer);

  [[nodiscard]] bool empty() const { return faults_.empty(); }
  void see(Printer& printer);
  [[nodiscard]] std::optional<Moment> next_at() const;
  [[nodiscard]] std::string to_board(std::string bytes, Moment now);
  [[nodiscard]] std::string to_host(std::string text, Moment now);
  [[nodiscard]] Moment delay(Moment now) const;
  /// How often any of them did harm so far.
  [[nodiscard]] std::int64_t count() const;

 private:
  Rng rng_;
  std::vector<std::unique_ptr<Fault>> faults_;
  std::int64_t past_ = 0;  ///< How often those did harm that are forgotten.
};

}  // namespace slipstick
