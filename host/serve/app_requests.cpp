#include "host/serve/app_requests.h"

#include <algorithm>

#include "core/base/check.h"
#include "host/serve/secrets.h"

namespace slipstick {

std::optional<std::string> AppRequests::ask(const AccountName& app, const std::string& from,
                                            Moment now) {
  forget_old(now);
  if (requests_.size() >= kWaitingMost) return {};
  std::string token = random_token();
  const std::int64_t id = ++last_;
  requests_.emplace(id, Request{token_hash(token), {id, app.text(), from}, now, now});
  return token;
}

std::vector<AppRequests::Waiting> AppRequests::waiting(Moment now) {
  forget_old(now);
  std::vector<Waiting> all;
  for (const auto& [id, request] : requests_) {
    if (request.key.empty()) all.push_back(request.who);
  }
  return all;
}

std::optional<std::string> AppRequests::answer(std::string_view token, Moment now) {
  forget_old(now);
  const std::string hash = token_hash(token);
  const auto at = std::ranges::find_if(
      requests_, [&](const auto& each) { return each.second.token_hash == hash; });
  if (at == requests_.end()) return {};
  at->second.heard = now;
  std::string key = at->second.key;
  if (!key.empty()) requests_.erase(at);
  return key;
}

std::optional<std::string> AppRequests::name_of(std::int64_t id, Moment now) {
  forget_old(now);
  const auto at = requests_.find(id);
  if (at == requests_.end() || !at->second.key.empty()) return {};
  return at->second.who.app;
}

void AppRequests::give(std::int64_t id, std::string key) {
  const auto at = requests_.find(id);
  SLIPSTICK_CHECK(at != requests_.end());
  at->second.key = std::move(key);
}

bool AppRequests::refuse(std::int64_t id) {
  return requests_.erase(id) == 1;
}

void AppRequests::forget_old(Moment now) {
  std::erase_if(requests_, [now](const auto& each) {
    return now - each.second.heard > kSilenceMost || now - each.second.asked > kAgeMost;
  });
}

}  // namespace slipstick
