#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace slipstick {

/// Who has a connection, and who gives way when there are too many: whoever has kept the server
/// waiting longest, so that clients that say nothing, or next to nothing, keep nobody out.
///
/// Knows no clock: whoever waits is put in the order in which the waits began.
class HttpSeats {
 public:
  using Seat = std::int64_t;

  enum class Doing : std::uint8_t {
    kSpeech,    ///< The client is to say what it wants. Gives way first.
    kTransfer,  ///< It is to send a body, or to take an answer. Gives way if no other does.
    kService,   ///< It waits for us, or listens to events. Never gives way.
  };

  /// \param total at the same time. \param of_one of one peer. \pre both positive.
  HttpSeats(int total, int of_one) : total_(total), of_one_(of_one) {}

  struct Place {
    Seat seat = 0;
    std::optional<Seat> freed;  ///< Of somebody who has to go; it is not counted any more.
  };
  /// A place, in kSpeech, for a client at `peer`; an empty one is this machine, which may have
  /// all. A peer that has its share already gets the place of one of its own. \return nothing if
  /// nobody gives way.
  [[nodiscard]] std::optional<Place> take(const std::string& peer);

  /// The holder of a seat begins something, or got on with it. Does nothing after `leave`.
  void does(Seat seat, Doing what);
  void leave(Seat seat);

  [[nodiscard]] int taken() const { return static_cast<int>(holders_.size()); }

 private:
  struct Holder {
    std::string peer;
    Doing doing = Doing::kSpeech;
    std::int64_t since = 0;
  };
  [[nodiscard]] int taken_by(const std::string& peer) const;
  [[nodiscard]] std::optional<Seat> to_give_way(const std::string* peer) const;

  const int total_;
  const int of_one_;
  std::map<Seat, Holder> holders_;
  Seat last_ = 0;
  std::int64_t turn_ = 0;
};

/// What `HttpSeats` counts as one: this machine is empty, an address of version 6 counts by its
/// first 64 bits, which one customer has.
/// \param address as text: "192.0.2.7", "2001:db8::1".
[[nodiscard]] std::string http_peer(const std::string& address);

}  // namespace slipstick
