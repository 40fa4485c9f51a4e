#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "host/serve/event_log.h"
#include "host/serve/hook.h"

namespace slipstick {

/// Tells hooks of what happens, one after the other, on a thread of its own. Nobody waits for them:
/// of occasions that come while hooks are slow the event log keeps the last 512 events, and what is
/// older is missed, which is logged.
class HookRunner {
 public:
  static constexpr std::size_t kHooksMax = 32;

  /// \pre At most `kHooksMax` hooks.
  HookRunner(std::vector<Hook> hooks, const EventLog& events);
  /// Tells of what was published before, for at most `kHookSeconds` and one hook more.
  ~HookRunner();
  HookRunner(const HookRunner&) = delete;
  HookRunner& operator=(const HookRunner&) = delete;

 private:
  void run();
  bool wait();
  bool may_go_on();
  void tell_news();
  void tell(const Occasion& occasion) const;

  const std::vector<Hook> hooks_;
  const EventLog& events_;
  OccasionFinder finder_;  ///< The thread's own.
  std::int64_t seen_ = 0;  ///< Likewise.

  std::mutex mutex_;  ///< Protects what follows.
  std::condition_variable stop_;
  std::optional<std::chrono::steady_clock::time_point> last_;  ///< Set: it is to end by then.

  std::thread thread_;  // last: it uses what stands above
};

}  // namespace slipstick
