#pragma once

#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "host/serve/push_hub.h"

namespace slipstick {

/// One listener of OctoPrint's push socket, without the socket: what it is to be told next, and
/// what it asks for. Until it is admitted it hears that it is connected, and nothing else.
///
/// It keeps no messages: whoever asks seldom is told seldom, and of the last state only.
class PushClient {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds kPace{500};  ///< Between two `current`.
  static constexpr std::int64_t kThrottleMax = 1'000;     ///< Times that.
  static constexpr std::chrono::seconds kHeartbeat{25};   ///< Of SockJS.
  static constexpr int kMessagesMax = 20;                 ///< Of the client, in a second.

  enum class Framing : std::uint8_t { kRaw, kSockJs };
  enum class Admission : std::uint8_t {
    kGranted,
    kByAuth,  ///< By an `auth` message with a session that the hub knows; lost by a wrong one.
  };

  PushClient(Framing framing, Admission admission)
      : framing_(framing), admission_(admission), admitted_(admission == Admission::kGranted) {}

  /// The next frame for the client, if there is anything to be said now.
  [[nodiscard]] std::optional<std::string> next(PushHub& hub, Time now);

  enum class Heard : std::uint8_t { kFine, kTooMuch };
  /// What the client says: `auth`, `subscribe`, `throttle`. What is none of these is ignored.
  /// \return kTooMuch: it says more than it may.
  [[nodiscard]] Heard hear(std::string_view frame, const PushHub& hub, Time now);
  /// A frame that is no message, a ping: it counts as one.
  [[nodiscard]] Heard count(Time now);

  [[nodiscard]] bool admitted() const { return admitted_; }
  /// What is to be said before the socket is closed, if anything.
  [[nodiscard]] std::optional<std::string> farewell() const;

 private:
  using Json = nlohmann::ordered_json;
  struct Wanted {
    bool state = true;
    bool logs = true;
    bool all_events = true;
    std::set<std::string> events;
  };

  void understand(const Json& message, const PushHub& hub);
  void subscribe(const Json& wishes);
  void throttle(const Json& factor);
  [[nodiscard]] std::optional<std::string> message(PushHub& hub, Time now);
  [[nodiscard]] std::optional<std::string> event(const PushHub& hub);
  [[nodiscard]] std::optional<std::string> state(PushHub& hub, Time now);
  [[nodiscard]] std::vector<std::string> new_logs(const PushHub& hub);

  const Framing framing_;
  const Admission admission_;
  bool admitted_;
  Wanted wanted_;
  std::int64_t throttle_ = 1;

  bool opened_ = false;
  bool greeted_ = false;
  bool began_ = false;        // `history` was told
  std::int64_t events_ = 0;   // of the hub's items, told or passed over
  std::int64_t logs_ = 0;     // likewise
  std::int64_t changes_ = 0;  // of the hub, at the last state
  Time state_told_{};
  Time spoke_{};

  Time second_{};  // in which messages are counted
  int heard_ = 0;
};

}  // namespace slipstick
