#pragma once

#include <string_view>

#include "core/base/rng.h"
#include "sim/faults/byte_faults.h"

namespace slipstick {

/// A share of the lines that go one way is lost, doubled or changed, of all lines or of one kind.
class LineFault final : public Fault {
 public:
  enum class Which : std::uint8_t { kAll, kOk, kResend };
  enum class Kind : std::uint8_t {
    kLost,
    kDoubled,
    kGarbled,     ///< Other bytes, as many of them.
    kGlued,       ///< Without its line end.
    kMisnumbered  ///< One digit is another.
  };

  LineFault(const FaultWhen& when, WireSide side, Which which, Kind kind, double share,
            std::uint64_t seed)
      : Fault(when), side_(side), which_(which), kind_(kind), share_(share), rng_(seed) {}

  [[nodiscard]] std::string to_board(std::string bytes, Moment now) override;
  [[nodiscard]] std::string to_host(std::string text, Moment now) override;

 private:
  /// The whole lines of `text`, each damaged by chance.
  [[nodiscard]] std::string damaged(std::string_view text);
  [[nodiscard]] std::string damaged_line(std::string line);
  [[nodiscard]] bool is_meant(std::string_view line) const;

  WireSide side_;
  Which which_;
  Kind kind_;
  double share_;
  Rng rng_;
  std::string half_;  ///< Of a line that the host has not ended.
};

}  // namespace slipstick
