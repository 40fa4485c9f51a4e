#include "host/serve/daemon.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <atomic>

#include "drivers/transport_address.h"
#include "drivers/unique_fd.h"
#include "host/serve/access.h"
#include "host/serve/api_key.h"
#include "host/serve/hook_runner.h"
#include "host/serve/octoprint.h"
#include "host/serve/service_manager.h"

namespace slipstick {
namespace {

Result<UniqueFd> lock_folder(const std::filesystem::path& folder) {
  UniqueFd lock(::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  if (lock.valid() && ::flock(lock.get(), LOCK_EX | LOCK_NB) == 0) return lock;
  return fail(
      ErrorCode::kUnavailable,
      fmt::format("{} is in use by another slipstick, or cannot be written", folder.string()));
}

Result<std::optional<CameraUrl>> camera_of(const Daemon::Options& options) {
  if (options.camera.empty()) return std::optional<CameraUrl>();
  auto url = CameraUrl::from(options.camera);
  if (!url) return fail(url.error());
  return std::optional(*std::move(url));
}

// The same mistakes as at the first job, but before there is one.
Result<void> check(const Daemon::Options& options) {
  const auto address = parse_transport_address(options.port);
  if (!address) return fail(address.error());
  const auto spec = job_spec_from_text("{}", options.defaults);
  if (!spec) return fail(spec.error());
  return {};
}

}  // namespace

class Daemon::Implementation {
 public:
  Implementation(UniqueFd lock, const Options& options)
      : lock_(std::move(lock)), options_(options), events_([this] { server_->wake(); }) {}

  Result<void> start() {
    if (!options_.hooks.empty()) hooks_.emplace(options_.hooks, events_);
    auto server = HttpServer::listen(options_.listen, site(), options_.http);
    if (!server) return fail(server.error());
    server_ = std::move(*server);
    if (const auto ok = make_rules(); !ok) return ok;
    const auto camera = camera_of(options_);
    if (!camera) return fail(camera.error());
    auto worker = PrinterWorker::start(
        {options_.data, options_.port, options_.defaults, options_.power_on}, board_, events_);
    if (!worker) return fail(worker.error());
    worker_ = std::move(*worker);
    const auto session = random_key();
    if (!session) return fail(session.error());
    for (auto* services : {&quick_, &slow_}) {
      auto store = Store::open(options_.data);
      if (!store) return fail(store.error());
      services->emplace(Services{std::move(*store),
                                 {},
                                 options_.defaults,
                                 options_.port,
                                 *worker_,
                                 board_,
                                 events_,
                                 began_,
                                 *camera,
                                 *session});
    }
    return tell_broker();
  }

  void run(const std::function<bool()>& goes_on) {
    tell_manager_ready();
    server_->run(events_, [&] {
      tell_manager_alive();
      return goes_on();
    });
    tell_manager_stopping();
  }
  [[nodiscard]] std::string url() const { return "http://" + server_->address(); }
  [[nodiscard]] const std::string& key() const { return key_; }

 private:
  HttpSite site() {
    return {[this](const HttpRequest& head) { return admit(head); },
            [this](const Route& route, const HttpRequest& request) {
              return route.handle(request, route.kind == RouteKind::kSlow ? *slow_ : *quick_);
            },
            [this] { return quick_->store.incoming(fmt::format("{}", ++uploads_)); }, push_site()};
  }

  // Browsers cannot show a key when they open a WebSocket: they say what a login gave them.
  PushSite push_site() {
    return {[this]() -> std::optional<OctoMoment> {
              auto moment = octo_moment(*quick_);
              return moment ? std::optional(std::move(*moment)) : std::nullopt;
            },
            [this](const HttpRequest& head) { return !rules_->check(head); },
            [this](std::string_view user, std::string_view session) {
              return user == kOctoPrintUser &&
                     equal_in_constant_time(session, quick_->push_session);
            }};
  }

  Result<void> tell_broker() {
    if (!options_.mqtt) return {};
    auto bridge = MqttBridge::start(*options_.mqtt, events_, board_,
                                    [this](PrinterCommand command) { return obey(command); });
    if (!bridge) return fail(bridge.error());
    bridge_ = std::move(*bridge);
    return {};
  }

  Result<void> obey(PrinterCommand command) {
    if (command == PrinterCommand::kEmergencyStop) return worker_->emergency_stop();
    const bool done = command == PrinterCommand::kPause    ? worker_->pause()
                      : command == PrinterCommand::kResume ? worker_->resume()
                                                           : worker_->cancel(board_.get().job);
    if (done) return {};
    return fail(ErrorCode::kPrinter, "no print is under way to which it applies");
  }

  Result<void> make_rules() {
    if (!server_->is_loopback()) {
      auto key = load_or_make_key(options_.data / "api_key");
      if (!key) return fail(key.error());
      key_ = std::move(*key);
    }
    rules_.emplace(key_);
    return {};
  }

  Found admit(const HttpRequest& head) const {
    Found found = find_route(head.method, head.target);
    const bool open = found.route != nullptr && found.route->access == RouteAccess::kAnyone;
    auto refusal = open ? rules_->check_site(head) : rules_->check(head);
    if (refusal) return {nullptr, {}, std::move(*refusal)};
    return found;
  }

  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  const UniqueFd lock_;
  const Options options_;
  std::string key_;
  std::optional<AccessRules> rules_;
  StatusBoard board_;
  EventLog events_;
  std::unique_ptr<HttpServer> server_;
  std::optional<Services> quick_;
  std::optional<Services> slow_;
  std::int64_t uploads_ = 0;
  std::optional<HookRunner> hooks_;
  std::unique_ptr<PrinterWorker> worker_;  // ends before those: it publishes events
  std::unique_ptr<MqttBridge> bridge_;     // ends first: it commands the worker
};

Daemon::Daemon(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

Daemon::~Daemon() = default;

Result<std::unique_ptr<Daemon>> Daemon::start(const Options& options) {
  if (const auto ok = check(options); !ok) return fail(ok.error());
  std::error_code error;
  std::filesystem::create_directories(options.data, error);
  auto lock = lock_folder(options.data);
  if (!lock) return fail(lock.error());
  auto implementation = std::make_unique<Implementation>(std::move(*lock), options);
  if (const auto ok = implementation->start(); !ok) return fail(ok.error());
  return std::unique_ptr<Daemon>(new Daemon(std::move(implementation)));
}

std::string Daemon::url() const {
  return implementation_->url();
}

const std::string& Daemon::key() const {
  return implementation_->key();
}

void Daemon::run(const std::function<bool()>& goes_on) {
  implementation_->run(goes_on);
}

}  // namespace slipstick
