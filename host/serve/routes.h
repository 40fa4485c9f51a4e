#pragma once

#include <chrono>
#include <span>
#include <string_view>

#include "host/serve/access.h"
#include "host/serve/accounts.h"
#include "host/serve/camera_url.h"
#include "host/serve/event_log.h"
#include "host/serve/http.h"
#include "host/serve/layer_preview.h"
#include "host/serve/login_desk.h"
#include "host/serve/printer_worker.h"
#include "host/serve/store.h"

namespace slipstick {

/// \file
/// Which request is answered by what. Handlers are functions from a request to a response; they do
/// not know sockets.

/// What handlers work with. Quick and slow routes run on different threads, each of which has its
/// own store, accounts and preview; the rest they share.
struct Services {
  Store store;
  Accounts accounts;
  LayerPreview preview;
  PrinterChoice words;  ///< What the command line says of the printer.
  PrinterWorker& printer;
  const StatusBoard& board;
  EventLog& events;
  LoginDesk& desk;
  std::chrono::steady_clock::time_point began;  ///< Of the daemon.
  std::optional<CameraUrl> camera = {};
  std::string push_session = "none";  ///< What a login gives for the push socket.
};

enum class RouteBody : std::uint8_t {
  kText,    ///< None, or a short one: JSON.
  kUpload,  ///< Received into a file.
  kForm,    ///< The file of a form likewise.
};

enum class RouteKind : std::uint8_t {
  kQuick,   ///< Answered at once.
  kSlow,    ///< On a thread of its own, one at a time.
  kSecret,  ///< Likewise; a password may be hashed, and only a few wait.
  kEvents,  ///< Becomes a stream of events.
  kPush,    ///< Becomes OctoPrint's push socket, if it is a WebSocket.
};

struct Route {
  HttpMethod method;
  std::string_view pattern;  ///< "/api/v1/jobs/{id}"; a last `{path}` is all that follows.
  RouteAccess access;
  HttpResponse (*handle)(const HttpRequest&, Services&);
  RouteBody body = RouteBody::kText;
  RouteKind kind = RouteKind::kQuick;
};

/// All of them.
[[nodiscard]] std::span<const Route> routes();

/// Where a request leads: a route and the parameters of its pattern, or the response that says why
/// not (404, 405).
struct Found {
  const Route* route = nullptr;
  std::map<std::string, std::string> parameters = {};
  HttpResponse refusal = {};
  Caller caller = {};
};
[[nodiscard]] Found find_route(HttpMethod method, const HttpTarget& target);

}  // namespace slipstick
