#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "drivers/transport.h"
#include "drivers/unique_fd.h"

namespace slipstick {

/// A transport over any descriptor that can be polled: a terminal, a socket, one end of a pair.
///
/// Threads: as `Transport` says. `shut_down` is a write to an eventfd and nothing else.
class FdTransport final : public Transport {
 public:
  /// Takes `fd` over and makes it non-blocking. `name` is for messages.
  /// Fails (kUnavailable) when the system has no descriptors left.
  [[nodiscard]] static Result<std::unique_ptr<FdTransport>> adopt(UniqueFd fd, std::string name);

  [[nodiscard]] Result<std::size_t> read_some(std::span<char> buffer,
                                              std::chrono::microseconds patience) override;
  [[nodiscard]] Result<std::size_t> write_some(std::string_view bytes,
                                               std::chrono::microseconds patience) override;
  [[nodiscard]] Result<void> write_all(std::string_view bytes,
                                       std::chrono::microseconds patience) override;
  void discard_output() noexcept override;
  bool set_dtr(bool on) noexcept override;
  void shut_down() noexcept override;
  [[nodiscard]] int descriptor() const noexcept override { return fd_.get(); }
  [[nodiscard]] std::string_view name() const override { return name_; }

 private:
  FdTransport(UniqueFd fd, UniqueFd bell, std::string name);

  /// Waits until `events` are possible; fails as `Transport::read_some` does.
  [[nodiscard]] Result<void> await(short events, std::chrono::microseconds until) const;
  [[nodiscard]] Error gone(int error) const;

  UniqueFd fd_;
  UniqueFd bell_;  ///< Readable for ever once `shut_down` was called.
  std::string name_;
};

}  // namespace slipstick
