#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace slipstick {

/// The last events of the daemon, for any number of listeners that come and go. A listener that is
/// too slow misses events and is told so; it holds nobody up and keeps nothing in memory.
///
/// Threads: any.
class EventLog {
 public:
  static constexpr std::size_t kKept = 512;

  struct Event {
    std::int64_t number = 0;  ///< From 1.
    std::string type;  ///< "state", "progress", "temperatures", "log", "files", "jobs", "apps",
                       ///< "emergency".
    std::string data;  ///< JSON on one line.
  };
  struct News {
    std::vector<Event> events;
    bool missed = false;  ///< There were others between.
  };

  /// \param wake called after each event, by the thread that published it; must not wait.
  explicit EventLog(std::function<void()> wake) : wake_(std::move(wake)) {}

  void publish(std::string type, std::string data);
  /// What came after event `number`, oldest first.
  [[nodiscard]] News since(std::int64_t number) const;
  /// The number of the last event; 0 before the first.
  [[nodiscard]] std::int64_t last() const;

 private:
  const std::function<void()> wake_;
  mutable std::mutex mutex_;  ///< Protects what follows.
  std::deque<Event> events_;
  std::int64_t last_ = 0;
};

}  // namespace slipstick
