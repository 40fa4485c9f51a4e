// Bytes on a connection: whatever a client sends before it stops, what it gets are whole responses,
// one after the other, or those and then whole frames of a WebSocket, and the end of the
// connection; the server serves the next one.
#include <charconv>
#include <string>
#include <thread>

#include "core/base/check.h"
#include "host/serve/http_server.h"
#include "tests/support/http_client.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/web_socket.h"

using namespace slipstick;

namespace {

/// The real routes, without what is behind them.
class Site {
 public:
  Site() {
    const std::string address = server_->address();
    port_ = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] bool nothing_left() const { return std::filesystem::is_empty(folder_.path()); }

 private:
  HttpSite site() {
    return {[](const HttpRequest& head) {
              Found found = find_route(head.method, head.target);
              const bool ends = found.route == nullptr || found.route->kind != RouteKind::kEvents;
              return ends ? found : Found{nullptr, {}, error_response(403, "it would not end")};
            },
            [](const Route&, const HttpRequest&) {
              return HttpResponse{200, "application/json", "{}\n", {}};
            },
            [this] { return folder_.path() / std::to_string(++uploads_); },
            {[] { return OctoMoment{}; }, [](const HttpRequest&) { return true; }, {}},
            [](const Caller&) { return true; }};
  }

  test::TemporaryFolder folder_;
  int uploads_ = 0;
  EventLog events_{[] {}};
  std::unique_ptr<HttpServer> server_ = *HttpServer::listen("127.0.0.1:0", site());
  std::uint16_t port_ = 0;
  std::jthread thread_{[this](const std::stop_token& stop) {
    server_->run(events_, [&] { return !stop.stop_requested(); });
  }};
};

// What the client gets after it is told that this is a WebSocket; empty if it is none.
std::string take_frames(std::string& all) {
  const std::size_t switched = all.find("HTTP/1.1 101 ");
  const std::size_t end = all.find("\r\n\r\n", std::min(switched, all.size()));
  if (end == std::string::npos) return "";
  std::string frames = all.substr(end + 4);
  all.erase(end + 4);
  return frames;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Site site;
  test::HttpClient client(site.port());
  client.send({reinterpret_cast<const char*>(data), size});
  client.end_sending();
  std::string all = client.read_until("\r\n\r\n") + client.read_until("no such text");
  std::string frames = take_frames(all);
  while (const auto frame = test::take_frame(frames)) SLIPSTICK_CHECK(!frame->masked);
  SLIPSTICK_CHECK(frames.empty());
  SLIPSTICK_CHECK(all.empty() || all.starts_with("HTTP/1.1 "));
  SLIPSTICK_CHECK(all.empty() || all.ends_with("\r\n\r\n") || all.ends_with("}\n"));
  SLIPSTICK_CHECK(test::request(site.port(), "GET", "/api/version").status == 200);
  SLIPSTICK_CHECK(site.nothing_left());
  return 0;
}
