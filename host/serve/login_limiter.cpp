#include "host/serve/login_limiter.h"

#include <algorithm>

namespace slipstick {
namespace {

using Seconds = LoginLimiter::Seconds;

// Names are of any size, and the same whatever their case, as in the database.
std::string short_form(std::string_view account) {
  constexpr std::size_t kKept = 64;
  std::string text(account.substr(0, kKept));
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

Seconds pause_after(int mistakes, Seconds most) {
  constexpr int kDoublingsMax = 20;
  if (mistakes <= LoginLimiter::kFree) return Seconds{0};
  const int doublings = std::min(mistakes - LoginLimiter::kFree - 1, kDoublingsMax);
  return std::min(Seconds{std::int64_t{1} << doublings}, most);
}

}  // namespace

Seconds LoginLimiter::wait(const std::string& account, const std::string& address, Time now) const {
  const auto left = [now](const Table& table, const std::string& who) {
    const auto at = table.find(who);
    if (at == table.end() || at->second.until <= now) return Seconds{0};
    return std::chrono::ceil<Seconds>(at->second.until - now);
  };
  return std::max(left(accounts_, short_form(account)), left(addresses_, address));
}

void LoginLimiter::failed(const std::string& account, const std::string& address, Time now) {
  note(accounts_, short_form(account), kAccountMost, now);
  note(addresses_, address, kAddressMost, now);
}

void LoginLimiter::succeeded(const std::string& account, const std::string& address) {
  accounts_.erase(short_form(account));
  addresses_.erase(address);
}

void LoginLimiter::note(Table& table, const std::string& who, Seconds most, Time now) {
  const auto by_wait = [](const auto& a, const auto& b) { return a.second.until < b.second.until; };
  if (table.size() >= kTableMax && !table.contains(who)) {
    table.erase(std::min_element(table.begin(), table.end(), by_wait));
  }
  Entry& entry = table[who];
  if (entry.mistakes > 0 && now >= entry.until + kForgotten) entry.mistakes = 0;
  ++entry.mistakes;
  entry.until = now + pause_after(entry.mistakes, most);
}

}  // namespace slipstick
