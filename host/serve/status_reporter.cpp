#include "host/serve/status_reporter.h"

#include <nlohmann/json.hpp>

namespace slipstick {
namespace {

using SteadyTime = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kInterval{250};

std::string one_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

void StatusReporter::job_began(std::int64_t id, const std::string& file) {
  PrinterStatus next;
  next.activity = PrinterActivity::kPrinting;
  next.firmware = status_.firmware;
  next.temperatures = status_.temperatures;
  next.job = id;
  next.file = file;
  status_ = next;
  status_.connected = true;
  status_.bed_occupied = true;
  began_ = SteadyTime::now();
  time_left_ = {};
  tell("state");
}

void StatusReporter::layer_began(PrintedLayer layer) {
  progress_told_ = {};  // of every layer something is told
  status_.layer = layer.layer;
  status_.height = layer.height;
  layer_ = std::make_shared<const PrintedLayer>(std::move(layer));
  board_.put_layer(layer_);
}

void StatusReporter::keep_time(PrintControl::Wish wish) {
  status_.seconds = std::chrono::duration<double>(SteadyTime::now() - began_).count();
  if (layer_ && status_.layers > 0) {
    completion((layer_->layer - 1 + share_done(*layer_, status_.lines)) / status_.layers);
  }
  if (wish == PrintControl::Wish::kRun) {
    time_left_.moved(status_.seconds, status_.completion);
  } else {
    time_left_.stood(status_.seconds);
  }
  status_.seconds_left = time_left_.seconds();
}

void StatusReporter::turn(PrintControl::Wish wish, const StreamFigures& figures) {
  status_.lines = static_cast<std::int64_t>(figures.counters.lines_acknowledged);
  keep_time(wish);
  using Wish = PrintControl::Wish;
  set(wish == Wish::kRun     ? PrinterActivity::kPrinting
      : wish == Wish::kPause ? PrinterActivity::kPaused
                             : PrinterActivity::kEnding);
  if (!due(progress_told_)) return;
  status_.lines_sent = static_cast<std::int64_t>(figures.counters.lines_sent);
  status_.resends = static_cast<std::int64_t>(figures.counters.resends);
  status_.starved_seconds = figures.starved_seconds;
  status_.turnaround_half = figures.turnaround.seconds_within(0.5);
  status_.turnaround_99 = figures.turnaround.seconds_within(0.99);
  tell("progress");
}

void StatusReporter::heard(const SenderEvent& event) {
  if (const auto* seen = std::get_if<TemperaturesSeen>(&event)) {
    status_.temperatures = seen->temperatures;
    if (!due(temperatures_told_)) return;
    board_.put(status_);
    events_.publish("temperatures", one_line(to_json(seen->temperatures)));
  } else if (const auto* firmware = std::get_if<FirmwareSeen>(&event)) {
    status_.firmware = firmware->name;
    tell("state");
  } else if (const auto* message = std::get_if<MessageSeen>(&event)) {
    events_.publish("log", one_line({{"text", message->text}}));
  } else if (const auto* answer = std::get_if<AnswerSeen>(&event)) {
    events_.publish("log", one_line({{"text", answer->text}}));
  } else if (const auto* action = std::get_if<ActionSeen>(&event)) {
    events_.publish("log", one_line({{"text", "the printer asks: " + action->text}}));
  }
}

void StatusReporter::job_came_to(std::int64_t id, std::string_view state,
                                 const std::string& message) {
  events_.publish(
      "jobs",
      one_line({{"id", id}, {"file", status_.file}, {"state", state}, {"message", message}}));
}

void StatusReporter::job_ended(PrinterActivity activity, const std::string& message) {
  status_.job = 0;
  layer_.reset();
  board_.put_layer(nullptr);
  status_.connected = false;
  status_.activity = activity;
  status_.message = message;
  tell("state");
}

void StatusReporter::bed(bool occupied) {
  status_.bed_occupied = occupied;
  tell("state");
}

void StatusReporter::connected(bool now, const std::string& message) {
  if (status_.connected == now && (now || status_.message == message)) return;
  status_.connected = now;
  status_.message = message;
  if (now) status_.activity = PrinterActivity::kIdle;
  tell("state");
}

void StatusReporter::set(PrinterActivity activity) {
  if (status_.activity == activity) return;
  status_.activity = activity;
  tell("state");
}

void StatusReporter::tell(const char* type) {
  board_.put(status_);
  events_.publish(type, one_line(to_json(status_)));
}

bool StatusReporter::due(SteadyTime::time_point& last) {
  const auto now = SteadyTime::now();
  if (now - last < kInterval) return false;
  last = now;
  return true;
}

}  // namespace slipstick
