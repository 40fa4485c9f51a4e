#pragma once

#include <chrono>
#include <map>
#include <string>

namespace slipstick {

/// How soon somebody may try a password again: after a few mistakes each takes twice as long as the
/// one before, by account and by address. Whether there is such an account makes no difference.
///
/// Both tables are bounded: who has least to wait is forgotten first, so that many names or
/// addresses that are made up drive out each other.
///
/// Threads: one. Knows no clock: each call is told the time.
class LoginLimiter {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Seconds = std::chrono::seconds;

  static constexpr int kFree = 5;  ///< Mistakes before there is anything to wait.
  /// Short, or anybody could keep the owner out by mistakes of his own.
  static constexpr Seconds kAccountMost{30};
  static constexpr Seconds kAddressMost{900};
  static constexpr Seconds kForgotten{900};  ///< After so long without a mistake.
  static constexpr std::size_t kTableMax = 1'000;

  /// How long to wait before a password is looked at; 0: not at all.
  /// \param account as it was typed. \param address as `http_peer` counts them.
  [[nodiscard]] Seconds wait(const std::string& account, const std::string& address,
                             Time now) const;
  void failed(const std::string& account, const std::string& address, Time now);
  void succeeded(const std::string& account, const std::string& address);

 private:
  struct Entry {
    int mistakes = 0;
    Time until;  // nothing is looked at before
  };
  using Table = std::map<std::string, Entry>;
  static void note(Table& table, const std::string& who, Seconds most, Time now);

  Table accounts_;
  Table addresses_;
};

}  // namespace slipstick
