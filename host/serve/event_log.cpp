#include "host/serve/event_log.h"

namespace slipstick {

void EventLog::publish(std::string type, std::string data) {
  {
    const std::lock_guard lock(mutex_);
    events_.push_back({++last_, std::move(type), std::move(data)});
    if (events_.size() > kKept) events_.pop_front();
  }
  wake_();
}

EventLog::News EventLog::since(std::int64_t number) const {
  const std::lock_guard lock(mutex_);
  News news;
  for (const Event& event : events_) {
    if (event.number > number) news.events.push_back(event);
  }
  news.missed = number < last_ && (news.events.empty() || news.events[0].number > number + 1);
  return news;
}

std::int64_t EventLog::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

}  // namespace slipstick
