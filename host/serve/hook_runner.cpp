#include "host/serve/hook_runner.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "core/base/check.h"

namespace slipstick {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};

}  // namespace

HookRunner::HookRunner(std::vector<Hook> hooks, const EventLog& events)
    : hooks_(std::move(hooks)), events_(events), seen_(events.last()) {
  SLIPSTICK_CHECK(hooks_.size() <= kHooksMax);
  thread_ = std::thread([this] { run(); });
}

HookRunner::~HookRunner() {
  {
    const std::lock_guard lock(mutex_);
    last_ = std::chrono::steady_clock::now() + std::chrono::seconds(kHookSeconds);
  }
  stop_.notify_all();
  thread_.join();
}

void HookRunner::run() {
  while (wait()) tell_news();
  tell_news();
}

// False when it is to end.
bool HookRunner::wait() {
  std::unique_lock lock(mutex_);
  return !stop_.wait_for(lock, kBetweenLooks, [this] { return last_.has_value(); });
}

bool HookRunner::may_go_on() {
  const std::lock_guard lock(mutex_);
  return !last_ || std::chrono::steady_clock::now() < *last_;
}

void HookRunner::tell_news() {
  const EventLog::News news = events_.since(seen_);
  if (news.missed) spdlog::warn("hooks are too slow: some events were missed");
  for (const EventLog::Event& event : news.events) {
    seen_ = event.number;
    for (const Occasion& occasion : finder_.occasions(event)) {
      if (may_go_on()) tell(occasion);
    }
  }
}

void HookRunner::tell(const Occasion& occasion) const {
  for (const Hook& hook : hooks_) {
    if (hook.on != occasion.kind) continue;
    if (const auto told = hook.target.tell(name_of(hook.on), occasion.told); !told)
      spdlog::warn("hook {}: {}", name_of(hook.on), told.error().message);
  }
}

}  // namespace slipstick
