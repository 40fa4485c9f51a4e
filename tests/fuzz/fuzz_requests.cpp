// Requests as a network sends them, to the handlers: the first line is METHOD TARGET, the rest the
// body. Whatever it is, the answer is no fault of the server, and JSON where it says so. There is
// no file, so that nothing is ever queued or printed.
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/check.h"
#include "host/serve/push_client.h"
#include "host/serve/routes.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;

namespace {

struct Site {
  test::TemporaryFolder folder;
  StatusBoard board;
  EventLog events{[] {}};
  std::unique_ptr<PrinterWorker> worker =
      *PrinterWorker::start({folder.path(), "sim:", {}}, board, events);
  LoginDesk desk{{}};
  Services services{*Store::open(folder.path()),
                    *Accounts::open(folder.path()),
                    {},
                    {"sim:", "generic_marlin"},
                    *worker,
                    board,
                    events,
                    desk,
                    {}};
};

HttpMethod method_of(std::string_view word) {
  if (word == "GET") return HttpMethod::kGet;
  if (word == "POST") return HttpMethod::kPost;
  if (word == "PUT") return HttpMethod::kPut;
  if (word == "DELETE") return HttpMethod::kDelete;
  return HttpMethod::kOther;
}

void check_json(std::string_view text) {
  const auto json = parse_json(text);
  if (json.is_discarded()) return;
  SLIPSTICK_CHECK(parse_json(json.dump()) == json);
}

// A listener of the push socket says it; what it hears is JSON.
void check_listener(std::string_view text, PushClient::Framing framing) {
  EventLog log{[] {}};
  PushHub hub({[] { return OctoMoment{}; }, {}, {}}, log);
  PushClient client(framing, PushClient::Admission::kGranted);
  SLIPSTICK_CHECK(client.hear(text, hub, {}) == PushClient::Heard::kFine ||
                  framing == PushClient::Framing::kSockJs);
  log.publish("files", R"({"name": "a.lua"})");
  hub.follow();
  const PushClient::Time later{std::chrono::hours(1'000)};
  while (const auto frame = client.next(hub, later)) {
    const bool sock_js = framing == PushClient::Framing::kSockJs;
    SLIPSTICK_CHECK(nlohmann::json::accept(frame->substr(sock_js ? 1 : 0)) || *frame == "o");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Site site;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::string_view line = input.substr(0, input.find('\n'));
  const std::size_t blank = std::min(line.find(' '), line.size());
  const auto target = parse_http_target(line.substr(std::min(blank + 1, line.size())));
  HttpRequest request;
  request.body = input.substr(std::min(line.size() + 1, input.size()));
  check_json(request.body);
  check_listener(request.body, PushClient::Framing::kRaw);
  check_listener(request.body, PushClient::Framing::kSockJs);
  if (!target) return 0;
  request.method = method_of(line.substr(0, blank));
  request.target = *target;
  Found found = find_route(request.method, *target);
  if (found.route == nullptr || found.route->body != RouteBody::kText) return 0;
  request.parameters = std::move(found.parameters);
  const HttpResponse response = found.route->handle(request, site.services);
  SLIPSTICK_CHECK(response.status >= 200 && response.status < 500);
  if (response.type != "application/json") return 0;
  SLIPSTICK_CHECK(nlohmann::json::accept(response.body));
  return 0;
}
