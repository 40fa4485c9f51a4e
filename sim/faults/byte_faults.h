#pragma once

#include "core/base/rng.h"
#include "sim/faults/fault.h"

namespace slipstick {

/// To the board or to the host.
enum class WireSide : std::uint8_t { kToBoard, kToHost };

/// A share of the bytes that go one way is damaged, all in the same manner.
class ByteFault final : public Fault {
 public:
  enum class Kind : std::uint8_t {
    kFlipped,
    kLost,
    kDoubled
  };  // one bit of the byte, or all of it

  ByteFault(const FaultWhen& when, WireSide side, Kind kind, double share, std::uint64_t seed)
      : Fault(when), side_(side), kind_(kind), share_(share), rng_(seed) {}

  [[nodiscard]] std::string to_board(std::string bytes, Moment now) override;
  [[nodiscard]] std::string to_host(std::string text, Moment now) override;

 private:
  [[nodiscard]] std::string damaged(std::string_view bytes);

  WireSide side_;
  Kind kind_;
  double share_;
  Rng rng_;
};

}  // namespace slipstick
