// The messages of OctoPrint's push socket: events.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "host/serve/http.h"
#include "host/serve/octoprint_push.h"

namespace slipstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kActivities{PrinterActivity::kIdle, PrinterActivity::kPrinting,
                                 PrinterActivity::kPaused, PrinterActivity::kEnding,
                                 PrinterActivity::kStopped};

std::optional<PrinterActivity> activity_of(std::string_view name) {
  const auto at =
      std::ranges::find_if(kActivities, [&](PrinterActivity a) { return name_of(a) == name; });
  return at == kActivities.end() ? std::nullopt : std::optional(*at);
}

// OctoPrint's name of what it calls octo_state.
std::string state_id(PrinterActivity activity) {
  std::string text(octo_state(activity));
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

Json file_payload(const std::string& name) {
  return {{"name", name}, {"path", name}, {"origin", "local"}};
}

Json stored_payload(const std::string& name) {
  return {{"storage", "local"}, {"path", name}, {"name", name}, {"type", octo_type_path(name)}};
}

}  // namespace

std::vector<PushEvent> PushEvents::heard(const EventLog::Event& event) {
  said_.clear();
  const Json json = parse_json(event.data);
  if (!json.is_object()) return {};
  if (event.type == "files") files(json);
  if (event.type == "jobs") job_over(json);
  if (event.type == "emergency") say("EStop", nullptr);
  if (event.type != "state" && event.type != "progress") return std::move(said_);
  Seen now{activity_of(json.value("state", "")), 0, "", 0, 0, json.value("message", ""),
           json.value("connected", false)};
  if (const auto job = json.find("job"); job != json.end() && job->is_object()) {
    now.job = job->value("id", std::int64_t{0});
    now.file = job->value("file", "");
    now.height = job->value("height", 0.0);
    now.seconds = job->value("seconds", 0.0);
  }
  status(now);
  seen_ = std::move(now);
  return std::move(said_);
}

void PushEvents::status(const Seen& now) {
  if (seen_.job != 0 && now.job == 0) end_message_ = now.message;
  connection(now);
  activity(now);
  if (now.job != 0 && now.job != seen_.job) say("PrintStarted", file_payload(now.file));
  if (now.job == 0 || now.height == 0) return;
  const bool same = now.job == seen_.job && seen_.height != 0;
  if (!same || now.height != seen_.height) {
    say("ZChange", {{"new", now.height}, {"old", same ? Json(seen_.height) : Json()}});
  }
}

// Between prints the daemon connects again at once, or says why it cannot: the end of a print is
// none of the connection.
void PushEvents::connection(const Seen& now) {
  const bool stopped = now.activity == PrinterActivity::kStopped;
  if (stopped && seen_.activity != PrinterActivity::kStopped) {
    say("Error", {{"error", now.message}, {"reason", "firmware"}});
  }
  if (now.connected && !stopped && !connected_) {
    connected_ = true;
    say("Connected", Json::object());
  } else if (connected_ && (stopped || (!now.connected && now.job == 0 && !now.message.empty() &&
                                        now.message != end_message_))) {
    connected_ = false;
    say("Disconnected", nullptr);
  }
}

void PushEvents::activity(const Seen& now) {
  if (!now.activity || now.activity == seen_.activity) return;
  say("PrinterStateChanged",
      {{"state_id", state_id(*now.activity)}, {"state_string", octo_state(*now.activity)}});
  if (now.job == 0 || now.job != seen_.job) return;
  if (now.activity == PrinterActivity::kPaused) say("PrintPaused", file_payload(now.file));
  if (now.activity == PrinterActivity::kEnding) say("PrintCancelling", file_payload(now.file));
  if (now.activity == PrinterActivity::kPrinting && seen_.activity == PrinterActivity::kPaused) {
    say("PrintResumed", file_payload(now.file));
  }
}

void PushEvents::files(const Json& json) {
  if (json.contains("removed")) {
    say("FileRemoved", stored_payload(json.value("removed", "")));
  } else {
    say("FileAdded", stored_payload(json.value("name", "")));
  }
  say("UpdatedFiles", {{"type", "printables"}});
}

// What the print under way came to. OctoPrint's clients hear of a cancelled one twice.
void PushEvents::job_over(const Json& json) {
  if (seen_.job == 0 || json.value("id", std::int64_t{0}) != seen_.job) return;
  const std::string state = json.value("state", "");
  Json payload = file_payload(seen_.file);
  payload["time"] = seen_.seconds;
  if (state == "done") return say("PrintDone", payload);
  if (state != "cancelled" && state != "failed" && state != "interrupted") return;
  if (state == "cancelled") say("PrintCancelled", payload);
  payload["reason"] = state == "cancelled" ? "cancelled" : "error";
  say("PrintFailed", payload);
}

void PushEvents::say(std::string name, const Json& payload) {
  const Json message{{"event", {{"type", name}, {"payload", payload}}}};
  said_.push_back({std::move(name), message.dump(-1, ' ', false, Json::error_handler_t::replace)});
}

}  // namespace slipstick
