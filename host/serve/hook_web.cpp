#include "host/serve/hook_web.h"

#include <curl/curl.h>
#include <fmt/format.h>

#include <memory>

#include "host/serve/hook.h"

namespace slipstick {
namespace {

struct Cleanup {
  void operator()(CURL* curl) const { curl_easy_cleanup(curl); }
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};

std::size_t drop(const char* /*bytes*/, std::size_t size, std::size_t count, void* /*nobody*/) {
  return size * count;
}

}  // namespace

Result<void> post_json(const std::string& url, const std::string& json) {
  const std::unique_ptr<CURL, Cleanup> curl(curl_easy_init());
  const std::unique_ptr<curl_slist, Cleanup> head(
      curl_slist_append(nullptr, "Content-Type: application/json"));
  if (!curl || !head) return fail(ErrorCode::kUnavailable, url + ": no memory for a request");
  curl_easy_setopt(curl.get(), CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl.get(), CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(curl.get(), CURLOPT_TIMEOUT, long{kHookSeconds});
  curl_easy_setopt(curl.get(), CURLOPT_NOSIGNAL, 1L);  // there are other threads
  curl_easy_setopt(curl.get(), CURLOPT_HTTPHEADER, head.get());
  curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDS, json.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDSIZE_LARGE, curl_off_t(json.size()));
  curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, &drop);
  const CURLcode done = curl_easy_perform(curl.get());
  if (done != CURLE_OK)
    return fail(ErrorCode::kUnavailable, fmt::format("{}: {}", url, curl_easy_strerror(done)));
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  if (status / 100 == 2) return {};
  return fail(ErrorCode::kUnavailable, fmt::format("{} answered {}", url, status));
}

}  // namespace slipstick
