#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/clock.h"
#include "drivers/serial_ports.h"
#include "drivers/transport_address.h"
#include "host/journal.h"

namespace slipstick {

/// The name by which the device at `address` is found again, on whatever port it comes back: its
/// USB ids and serial number, if `ports` tells them and no other has the same; else `address`.
[[nodiscard]] TransportAddress lasting_address(const TransportAddress& address,
                                               const std::vector<SerialPort>& ports);

/// A printer's port that may go away in the middle of a print, and come back.
///
/// Threads: one.
class ReturningPort {
 public:
  /// For so long it is waited for: a nozzle stands hot on the part meanwhile.
  static constexpr Moment kPatience = std::chrono::minutes(10);
  /// A cable that is loose more often is no cable.
  static constexpr int kReturnsMax = 50;

  struct Waiting {
    std::function<void(const std::string&)> tell{};  ///< What is waited for, and that it is back.
    std::function<bool()> ended{};                   ///< Whether somebody wants no more of it.
    Moment patience = kPatience;
    Moment between_looks = std::chrono::milliseconds(500);
  };

  ReturningPort(TransportAddress address, Waiting waiting)
      : address_(std::move(address)), waiting_(std::move(waiting)) {}

  /// Where to look for the printer. \return the address as it is to be opened now.
  [[nodiscard]] const TransportAddress& address();

  /// What the opening of the port, or the first words over it, failed with: once it has come back
  /// it may go again meanwhile, which is kDisconnected then.
  [[nodiscard]] Error met(Error error) const;
  /// Whether `error` of an attempt means that the port is away.
  [[nodiscard]] bool lost(const Error& error) const;

  /// Waits until it can be opened. \return false if it did not come back, or nobody wants it to.
  [[nodiscard]] bool comes_back();

  [[nodiscard]] int returns() const { return returns_; }

 private:
  TransportAddress address_;
  Waiting waiting_;
  int returns_ = 0;
};

/// Makes `attempt(nothing)`, and while the port is lost in it and comes back, `attempt(journal)`
/// with what the journal at `path` says by then. Without a journal nothing is attempted again.
/// \return what the last attempt did.
template <typename Attempt>
auto print_through_gaps(ReturningPort& port, const std::filesystem::path& path, Attempt attempt)
    -> decltype(attempt(std::optional<JournalContent>())) {
  auto done = attempt(std::optional<JournalContent>());
  while (!done && port.lost(done.error())) {
    auto content = read_journal(path);
    if (!content || !port.comes_back()) break;
    done = attempt(std::optional(*std::move(content)));
  }
  return done;
}

}  // namespace slipstick
