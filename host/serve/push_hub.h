#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "host/serve/http.h"
#include "host/serve/octoprint_push.h"

namespace slipstick {

/// What the push socket asks of the site.
struct PushSite {
  /// How things are now; nothing if that cannot be told.
  std::function<std::optional<OctoMoment>()> moment;
  /// Whether whoever opens a socket by this request may listen without an `auth` message.
  std::function<bool(const HttpRequest& head)> admits;
  /// Whether the user of an `auth` message has such a session.
  std::function<bool(std::string_view user, std::string_view session)> knows;
};

/// What all listeners of the push socket share: the last events in OctoPrint's words, and how
/// things are, looked up once a turn of the server however many listen. A listener that is too
/// slow misses events.
///
/// Threads: the server's.
class PushHub {
 public:
  static constexpr std::size_t kKept = 256;

  enum class Kind : std::uint8_t { kEvent, kLog };
  struct Item {
    std::int64_t number = 0;  ///< From 1.
    Kind kind = Kind::kEvent;
    PushEvent event;  ///< Of a log only the text.
  };

  /// \pre `log` outlives this.
  PushHub(PushSite site, const EventLog& log)
      : site_(std::move(site)), log_(log), heard_(log.last()) {}

  /// Takes in what is new: at the beginning of each turn.
  void follow();

  /// The last ones, oldest first.
  [[nodiscard]] const std::deque<Item>& items() const { return items_; }
  /// The number of the last one; 0 before the first.
  [[nodiscard]] std::int64_t last() const { return last_; }
  /// Grows with all that happens, also what is no item.
  [[nodiscard]] std::int64_t changes() const { return heard_; }
  /// As of this turn.
  [[nodiscard]] const std::optional<OctoMoment>& moment();

  [[nodiscard]] bool admits(const HttpRequest& head) const;
  [[nodiscard]] bool knows(std::string_view user, std::string_view session) const;

 private:
  void keep(Kind kind, PushEvent event);

  const PushSite site_;
  const EventLog& log_;
  PushEvents events_;
  std::int64_t heard_;
  std::deque<Item> items_;
  std::int64_t last_ = 0;
  std::optional<OctoMoment> moment_;
  bool looked_ = false;  // this turn
};

}  // namespace slipstick
