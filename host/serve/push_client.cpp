#include "host/serve/push_client.h"

#include <nlohmann/json.hpp>

namespace slipstick {

std::optional<std::string> PushClient::next(PushHub& hub, Time now) {
  const bool sock_js = framing_ == Framing::kSockJs;
  if (!opened_) {
    opened_ = true;
    spoke_ = now;
    if (sock_js) return "o";
  }
  if (auto text = message(hub, now)) {
    spoke_ = now;
    return sock_js ? sock_js_frame(*text) : std::move(*text);
  }
  if (!sock_js || now - spoke_ < kHeartbeat) return {};
  spoke_ = now;
  return "h";
}

std::optional<std::string> PushClient::message(PushHub& hub, Time now) {
  if (!greeted_) {
    greeted_ = true;
    return push_connected();
  }
  if (!admitted_) return {};
  if (!began_) events_ = hub.last();
  if (auto text = event(hub)) return text;
  return state(hub, now);
}

std::optional<std::string> PushClient::event(const PushHub& hub) {
  for (const PushHub::Item& item : hub.items()) {
    if (item.number <= events_) continue;
    events_ = item.number;
    if (item.kind != PushHub::Kind::kEvent) continue;
    if (wanted_.all_events || wanted_.events.contains(item.event.name)) return item.event.text;
  }
  return {};
}

std::optional<std::string> PushClient::state(PushHub& hub, Time now) {
  if (began_ &&
      (!wanted_.state || hub.changes() == changes_ || now - state_told_ < kPace * throttle_)) {
    return {};
  }
  const auto& moment = hub.moment();
  if (!moment) return {};
  std::string text = push_state(began_ ? "current" : "history", *moment, new_logs(hub));
  began_ = true;
  changes_ = hub.changes();
  state_told_ = now;
  return text;
}

std::vector<std::string> PushClient::new_logs(const PushHub& hub) {
  std::vector<std::string> logs;
  for (const PushHub::Item& item : hub.items()) {
    const bool is_new = item.number > logs_ && item.kind == PushHub::Kind::kLog;
    if (is_new && wanted_.logs) logs.push_back(item.event.text);
  }
  logs_ = hub.last();
  return logs;
}

PushClient::Heard PushClient::count(Time now) {
  if (now - second_ >= std::chrono::seconds(1)) {
    second_ = now;
    heard_ = 0;
  }
  return ++heard_ > kMessagesMax ? Heard::kTooMuch : Heard::kFine;
}

// With SockJS a frame is a text or an array of texts, each of which is a message.
PushClient::Heard PushClient::hear(std::string_view frame, const PushHub& hub, Time now) {
  if (count(now) == Heard::kTooMuch) return Heard::kTooMuch;
  const Json json = parse_json(frame);
  if (framing_ == Framing::kRaw) {
    understand(json, hub);
    return Heard::kFine;
  }
  const Json messages = json.is_array() ? json : Json::array({json});
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (i > 0 && count(now) == Heard::kTooMuch) return Heard::kTooMuch;
    if (messages[i].is_string()) understand(parse_json(messages[i].get<std::string>()), hub);
  }
  return Heard::kFine;
}

void PushClient::understand(const Json& message, const PushHub& hub) {
  if (!message.is_object()) return;
  if (const auto at = message.find("throttle"); at != message.end()) throttle(*at);
  if (const auto at = message.find("subscribe"); at != message.end()) subscribe(*at);
  const auto auth = message.find("auth");
  if (auth == message.end() || !auth->is_string() || admission_ == Admission::kGranted) return;
  const std::string text = auth->get<std::string>();
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view session = std::string_view(text).substr(std::min(colon + 1, text.size()));
  admitted_ = hub.knows(std::string_view(text).substr(0, colon), session);
}

// What is not named is not wanted. Of logs there are all or none: a pattern stands for all, as
// patterns of strangers are not to be tried on texts of printers.
void PushClient::subscribe(const Json& wishes) {
  if (!wishes.is_object()) return;
  const auto wanted = [](const Json& in, const char* key) {
    const auto at = in.find(key);
    return at != in.end() && !at->is_null() && *at != false;
  };
  wanted_ = {wanted(wishes, "state"), false, wishes.value("events", Json()) == true, {}};
  if (wanted_.state) {
    wanted_.logs =
        wishes["state"] == true || (wishes["state"].is_object() && wanted(wishes["state"], "logs"));
  }
  if (!wishes.contains("events") || !wishes["events"].is_array()) return;
  for (const Json& name : wishes["events"]) {
    if (name.is_string()) wanted_.events.insert(name.get<std::string>());
  }
}

void PushClient::throttle(const Json& factor) {
  if (!factor.is_number_integer()) return;
  const auto times = factor.get<std::int64_t>();
  if (times >= 1 && times <= kThrottleMax) throttle_ = times;
}

std::optional<std::string> PushClient::farewell() const {
  if (framing_ == Framing::kRaw) return {};
  return "c[3000,\"Go away!\"]";
}

}  // namespace slipstick
