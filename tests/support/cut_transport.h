#pragma once

#include "sim/sim_transport.h"

namespace slipstick::test {

/// A cable that breaks in the middle of a write, for good. The printer lives on.
class CutTransport final : public Transport {
 public:
  static constexpr int kNever = 1'000'000;

  /// \param writes how many get through before.
  CutTransport(SimTransport& sim, int writes) : sim_(sim), writes_(writes) {}

  Result<std::size_t> read_some(std::span<char> buffer,
                                std::chrono::microseconds patience) override {
    if (writes_ < 0) return gone();
    return sim_.read_some(buffer, patience);
  }
  Result<std::size_t> write_some(std::string_view bytes,
                                 std::chrono::microseconds patience) override {
    const bool cut = writes_-- <= 0;
    if (!cut) return sim_.write_some(bytes, patience);
    // All of it, half, or nothing.
    const std::size_t kept = bytes.size() - bytes.size() * (bytes.size() % 3) / 2;
    if (writes_ == -1 && kept > 0) (void)sim_.write_some(bytes.substr(0, kept), patience);
    return gone();
  }
  Result<void> write_all(std::string_view bytes, std::chrono::microseconds patience) override {
    const auto done = write_some(bytes, patience);
    return done ? Result<void>() : fail(done.error());
  }
  void shut_down() noexcept override { sim_.shut_down(); }
  std::string_view name() const override { return "frail"; }

 private:
  static tl::unexpected<Error> gone() { return fail(ErrorCode::kUnavailable, "frail: gone"); }

  SimTransport& sim_;
  int writes_;
};

}  // namespace slipstick::test
