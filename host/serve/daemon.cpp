#include "host/serve/daemon.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>

#include <atomic>
#include <ctime>

#include "drivers/transport_address.h"
#include "drivers/unique_fd.h"
#include "host/serve/access.h"
#include "host/serve/api_key.h"
#include "host/serve/hook_runner.h"
#include "host/serve/login_desk.h"
#include "host/serve/octoprint.h"
#include "host/serve/secrets.h"
#include "host/serve/service_manager.h"
#include "host/serve/setup_code.h"

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
Result<void> check_printer(const std::string& port, const JobDefaults& defaults) {
  const auto address = parse_transport_address(port);
  if (!address) return fail(address.error());
  const auto spec = job_spec_from_text("{}", defaults);
  if (!spec) return fail(spec.error());
  return {};
}

std::int64_t now() {
  return std::int64_t{std::time(nullptr)};
}

// What the owner of the folder put there because he forgot the password.
Result<void> forget_accounts_if_told(const std::filesystem::path& data, Accounts& accounts) {
  const auto file = data / "forget_accounts";
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  if (const auto ok = accounts.forget_all(); !ok) return ok;
  if (std::filesystem::remove(file, error)) return {};
  return fail(ErrorCode::kUnavailable, fmt::format("cannot remove {}", file.string()));
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
    if (const auto ok = open_desk(); !ok) return ok;
    const auto camera = camera_of(options_);
    if (!camera) return fail(camera.error());
    if (const auto ok = start_worker(); !ok) return ok;
    const std::string session = random_token();
    for (auto* services : {&quick_, &slow_}) {
      auto store = Store::open(options_.data);
      if (!store) return fail(store.error());
      auto accounts = Accounts::open(options_.data);
      if (!accounts) return fail(accounts.error());
      services->emplace(Services{std::move(*store),
                                 std::move(*accounts),
                                 {},
                                 words(),
                                 *worker_,
                                 board_,
                                 events_,
                                 *desk_,
                                 began_,
                                 *camera,
                                 session});
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
  [[nodiscard]] std::string setup_code() const { return desk_->setup ? desk_->setup->text() : ""; }

 private:
  [[nodiscard]] PrinterChoice words() const { return {options_.port, options_.defaults.printer}; }

  // Of a printer that was chosen, all must still be there.
  Result<void> start_worker() {
    auto store = Store::open(options_.data);
    if (!store) return fail(store.error());
    const auto chosen = store->printer_instead_of(words());
    if (!chosen) return fail(chosen.error());
    PrinterWorker::Options options{options_.data, chosen->port, options_.defaults,
                                   options_.power_on};
    options.defaults.printer = chosen->machine;
    if (const auto ok = check_printer(options.port, options.defaults); !ok) {
      spdlog::warn("the printer that was chosen: {}; using {}", ok.error().message, options_.port);
      options.port = options_.port;
      options.defaults = options_.defaults;
    }
    auto worker = PrinterWorker::start(std::move(options), board_, events_);
    if (!worker) return fail(worker.error());
    worker_ = std::move(*worker);
    return {};
  }

  HttpSite site() {
    return {[this](const HttpRequest& head) { return admit(head); },
            [this](const Route& route, const HttpRequest& request) {
              const bool is_slow =
                  route.kind == RouteKind::kSlow || route.kind == RouteKind::kSecret;
              return route.handle(request, is_slow ? *slow_ : *quick_);
            },
            [this] { return quick_->store.incoming(fmt::format("{}", ++uploads_)); }, push_site(),
            [this](const Caller& caller) {
              const auto good = quick_->accounts.still_good(caller, now());
              return good && *good;
            }};
  }

  // Browsers cannot show a key when they open a WebSocket: they say what a login gave them.
  PushSite push_site() {
    return {[this]() -> std::optional<OctoMoment> {
              auto moment = octo_moment(*quick_);
              return moment ? std::optional(std::move(*moment)) : std::nullopt;
            },
            [this](const HttpRequest& head) {
              return !rules_->check(RouteAccess::kRead, head, quick_->accounts, now()).refusal;
            },
            // One secret for all who may read, whatever their names.
            [this](std::string_view /*user*/, std::string_view session) {
              return equal_in_constant_time(session, quick_->push_session);
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

  // On the loopback a key that is there counts, too, once there is an account.
  Result<void> make_rules() {
    const auto file = options_.data / "api_key";
    std::string key;
    if (!server_->is_loopback() || std::filesystem::exists(file)) {
      auto loaded = load_or_make_key(file);
      if (!loaded) return fail(loaded.error());
      key = std::move(*loaded);
    }
    if (!server_->is_loopback()) key_ = key;
    rules_.emplace(server_->is_loopback() ? Reach::kMachine : Reach::kNetwork, std::move(key));
    return {};
  }

  Result<void> open_desk() {
    const auto store = Store::open(options_.data);  // makes the tables
    if (!store) return fail(store.error());
    auto accounts = Accounts::open(options_.data);
    if (!accounts) return fail(accounts.error());
    if (const auto ok = forget_accounts_if_told(options_.data, *accounts); !ok) return ok;
    const auto any = accounts->any();
    if (!any) return fail(any.error());
    if (*any || server_->is_loopback()) {
      desk_.emplace(LoginDesk{{}});
      return {};
    }
    auto code = SetupCode::load_or_make(options_.data / "setup_code");
    if (!code) return fail(code.error());
    desk_.emplace(LoginDesk{std::move(*code)});
    return {};
  }

  Found admit(const HttpRequest& head) {
    Found found = find_route(head.method, head.target);
    // Who may not look is not told what there is.
    const auto needed = found.route == nullptr ? RouteAccess::kRead : found.route->access;
    auto verdict = rules_->check(needed, head, quick_->accounts, now());
    if (verdict.refusal) return {nullptr, {}, std::move(*verdict.refusal)};
    found.caller = std::move(verdict.caller);
    return found;
  }

  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  const UniqueFd lock_;
  const Options options_;
  std::string key_;
  std::optional<AccessRules> rules_;
  std::optional<LoginDesk> desk_;
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
  if (const auto ok = check_printer(options.port, options.defaults); !ok) return fail(ok.error());
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

std::string Daemon::setup_code() const {
  return implementation_->setup_code();
}

void Daemon::run(const std::function<bool()>& goes_on) {
  implementation_->run(goes_on);
}

}  // namespace slipstick
