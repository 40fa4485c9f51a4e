#include "host/serve/push_hub.h"

#include <nlohmann/json.hpp>

namespace slipstick {

void PushHub::follow() {
  looked_ = false;
  if (log_.last() == heard_) return;
  for (const EventLog::Event& event : log_.since(heard_).events) {
    heard_ = event.number;
    for (PushEvent& said : events_.heard(event)) keep(Kind::kEvent, std::move(said));
    if (event.type != "log") continue;
    const auto json = parse_json(event.data);
    if (json.is_object()) keep(Kind::kLog, {"", "Recv: " + json.value("text", "")});
  }
}

const std::optional<OctoMoment>& PushHub::moment() {
  if (!looked_) moment_ = site_.moment ? site_.moment() : std::nullopt;
  looked_ = true;
  return moment_;
}

bool PushHub::admits(const HttpRequest& head) const {
  return site_.admits && site_.admits(head);
}

bool PushHub::knows(std::string_view user, std::string_view session) const {
  return site_.knows && site_.knows(user, session);
}

void PushHub::keep(Kind kind, PushEvent event) {
  items_.push_back({++last_, kind, std::move(event)});
  if (items_.size() > kKept) items_.pop_front();
}

}  // namespace slipstick
