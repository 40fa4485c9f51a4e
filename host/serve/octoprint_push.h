#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/serve/event_log.h"
#include "host/serve/octoprint_state.h"

namespace slipstick {

/// \file
/// What OctoPrint's push socket says (OctoPrint 1.10, docs/api/push.rst), without the socket: each
/// message is an object with one key, as JSON on one line.

/// Said first, to everybody.
[[nodiscard]] std::string push_connected();

/// The whole state. \param kind "history" or "current". \param logs what the printer said since the
/// last one.
[[nodiscard]] std::string push_state(std::string_view kind, const OctoMoment& moment,
                                     const std::vector<std::string>& logs);

/// `message` as a SockJS array frame, `a["…"]`.
[[nodiscard]] std::string sock_js_frame(std::string_view message);

/// Something that happened, in OctoPrint's words.
struct PushEvent {
  std::string name;  ///< "PrintStarted"
  std::string text;  ///< The message: `{"event": {"type": …, "payload": …}}`.
};

/// Turns the daemon's events into OctoPrint's: what changed from one state to the next.
class PushEvents {
 public:
  /// What `event` tells, in order. Events are to come in the order of their numbers; others between
  /// may be missing.
  [[nodiscard]] std::vector<PushEvent> heard(const EventLog::Event& event);

 private:
  struct Seen {
    std::optional<PrinterActivity> activity;
    std::int64_t job = 0;
    std::string file;
    double height = 0;
    double seconds = 0;
    std::string message;
    bool connected = false;
  };

  void status(const Seen& now);
  void connection(const Seen& now);
  void activity(const Seen& now);
  void files(const nlohmann::ordered_json& json);
  void job_over(const nlohmann::ordered_json& json);
  void say(std::string name, const nlohmann::ordered_json& payload);

  Seen seen_;
  bool connected_ = false;   // as it was told
  std::string end_message_;  // of the last print: not why a connection is lost
  std::vector<PushEvent> said_;
};

}  // namespace slipstick
