#include "host/serve/http_seats.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/network_v6.hpp>

namespace slipstick {

std::optional<HttpSeats::Place> HttpSeats::take(const std::string& peer) {
  const bool has_its_share = !peer.empty() && taken_by(peer) >= of_one_;
  Place place;
  if (has_its_share || taken() >= total_) {
    place.freed = to_give_way(has_its_share ? &peer : nullptr);
    if (!place.freed) return {};
    leave(*place.freed);
  }
  place.seat = ++last_;
  holders_.emplace(place.seat, Holder{peer, Doing::kSpeech, ++turn_});
  return place;
}

void HttpSeats::does(Seat seat, Doing what) {
  const auto at = holders_.find(seat);
  if (at == holders_.end()) return;
  at->second.doing = what;
  at->second.since = ++turn_;
}

void HttpSeats::leave(Seat seat) {
  holders_.erase(seat);
}

int HttpSeats::taken_by(const std::string& peer) const {
  return static_cast<int>(std::ranges::count_if(
      holders_, [&](const auto& holder) { return holder.second.peer == peer; }));
}

std::optional<HttpSeats::Seat> HttpSeats::to_give_way(const std::string* peer) const {
  const std::pair<const Seat, Holder>* first = nullptr;
  const auto order = [](const Holder& holder) { return std::pair(holder.doing, holder.since); };
  for (const auto& each : holders_) {
    if (each.second.doing == Doing::kService || (peer != nullptr && each.second.peer != *peer)) {
      continue;
    }
    if (first == nullptr || order(each.second) < order(first->second)) first = &each;
  }
  return first == nullptr ? std::nullopt : std::optional(first->first);
}

std::string http_peer(const std::string& address) {
  namespace ip = boost::asio::ip;
  boost::system::error_code error;
  ip::address at = ip::make_address(address, error);
  if (error) return address;
  if (at.is_v6() && at.to_v6().is_v4_mapped()) at = ip::make_address_v4(ip::v4_mapped, at.to_v6());
  if (at.is_loopback()) return "";
  if (at.is_v4()) return at.to_string();
  return ip::network_v6(at.to_v6(), 64).canonical().to_string();
}

}  // namespace slipstick
