// Harm that is done to what goes through a cable.
#include "tests/support/bench_cable.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace slipstick::test {
namespace {

// The one that the bench turned over: "N" came as "L", "0" as "2".
constexpr char kFlipped = 2;

// One less, if there are any. \return Whether there were.
bool take(std::size_t& count) {
  if (count == 0) return false;
  --count;
  return true;
}

}  // namespace

bool BenchCable::command(std::string_view words) {
  const std::size_t space = words.find(' ');
  if (space == std::string_view::npos) return false;
  const std::string_view digits = words.substr(space + 1);
  std::size_t count = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) return false;
  const std::pair<std::string_view, std::size_t BenchCable::*> commands[] = {
      {"flip-rx", &BenchCable::flip_rx_},
      {"flip-tx", &BenchCable::flip_tx_},
      {"flip-rx-every", &BenchCable::flip_every_},
      {"drop-rx", &BenchCable::drop_rx_},
      {"drop-tx", &BenchCable::drop_tx_},
      {"swallow-ok", &BenchCable::swallow_ok_},
      {"dup-ok", &BenchCable::double_ok_},
      {"mute", &BenchCable::mute_},
      {"deaf", &BenchCable::deaf_},
      {"noise", &BenchCable::noise_}};
  for (const auto& [name, member] : commands) {
    if (words.substr(0, space) != name) continue;
    this->*member = count;
    since_flip_ = 0;
    return true;
  }
  return false;
}

std::string BenchCable::to_board(std::string_view bytes) {
  std::string through;
  if (deaf_ != 0) return through;
  for (char byte : bytes) {
    if (take(drop_rx_)) continue;
    const bool due = flip_every_ != 0 && byte != '\n' && ++since_flip_ % flip_every_ == 0;
    if (take(flip_rx_) || due) byte = static_cast<char>(byte ^ kFlipped);
    through += byte;
  }
  return through;
}

std::vector<std::string> BenchCable::to_host(std::string line) {
  if (mute_ != 0) return {};
  const bool ok = line == "ok";
  if (ok && take(swallow_ok_)) return {};
  const std::size_t lost = std::min(drop_tx_, line.size());
  line.erase(0, lost);
  drop_tx_ -= lost;
  for (char& byte : line) {
    if (!take(flip_tx_)) break;
    byte = static_cast<char>(byte ^ kFlipped);
  }
  if (ok && take(double_ok_)) return {line, line};
  return {line};
}

std::size_t BenchCable::take_noise() {
  return std::exchange(noise_, 0);
}

}  // namespace slipstick::test
