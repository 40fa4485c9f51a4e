// PrinterWorker between prints: which printer there is, and the connection to it.
#include "drivers/open_transport.h"
#include "host/serve/idle_connection.h"
#include "host/serve/printer_worker.h"

namespace slipstick {
namespace {

/// Where the printer is not there, or does not answer.
constexpr std::chrono::seconds kBetweenConnections{5};

}  // namespace

std::string PrinterWorker::port() {
  const std::lock_guard lock(mutex_);
  return port_;
}

JobDefaults PrinterWorker::defaults() {
  const std::lock_guard lock(mutex_);
  return defaults_;
}

Result<void> PrinterWorker::use(const PrinterChoice& choice) {
  {
    const std::lock_guard lock(mutex_);
    if (control_) return fail(ErrorCode::kPrinter, "a print is under way");
    if (idle_ && port_ != choice.port) idle_->cancel();
    port_ = choice.port;
    defaults_.printer = choice.machine;
    look_again_ = true;
    left_alone_ = false;
  }
  changed_.notify_all();
  return {};
}

// False when the worker is to end.
bool PrinterWorker::wait_for_work() {
  const bool lost = may_connect() && !stay_idle();
  std::unique_lock lock(mutex_);
  const auto called = [this] { return look_again_ || stopping_; };
  if (lost) {
    changed_.wait_for(lock, kBetweenConnections, called);
  } else {
    changed_.wait(lock, called);
  }
  look_again_ = false;
  return !stopping_;
}

bool PrinterWorker::is_called() {
  const std::lock_guard lock(mutex_);
  return look_again_ || stopping_;
}

bool PrinterWorker::may_connect() {
  const auto address = parse_transport_address(port());
  if (!address || address->kind == TransportKind::kSim) return false;
  const auto cut_off = store_.print_is_cut_off();
  const std::lock_guard lock(mutex_);
  return cut_off && !*cut_off && !left_alone_ && !look_again_ && !stopping_;
}

// Until there is work. Whether the connection was there until then.
Result<void> PrinterWorker::stay_idle() {
  auto transport = open_transport(*parse_transport_address(port()));
  if (!transport) {
    reporter_.connected(false, transport.error().message);
    return fail(transport.error());
  }
  const auto control = begin_idle();
  const SteadyClock clock;
  std::optional<LoggedTransport> printer(std::in_place, *std::move(transport), *serial_log_);
  const auto how = stay_connected(*printer, clock, *control, [this] { return is_called(); });
  const bool stopped = end_idle();
  printer.reset();
  if (stopped) stop_again();
  const std::string message = how ? "" : how.error().message;
  if (stopped || halted_) {
    reporter_.job_ended(PrinterActivity::kStopped, message);
  } else {
    reporter_.connected(false, message);
  }
  return how;
}

std::shared_ptr<PrintControl> PrinterWorker::begin_idle() {
  const std::lock_guard lock(mutex_);
  idle_ = std::make_shared<PrintControl>(
      PrintControl::Listeners{[this](const SenderEvent& event) { reporter_.heard(event); },
                              [this](SenderState state, const StreamFigures&) {
                                halted_ |= state == SenderState::kHalted;
                                if (state == SenderState::kReady) reporter_.connected(true, "");
                              }});
  halted_ = false;
  return idle_;
}

// Whether it was to be stopped at once.
bool PrinterWorker::end_idle() {
  const std::lock_guard lock(mutex_);
  const auto wish = std::exchange(idle_, nullptr)->wish();
  const bool stopped = wish == PrintControl::Wish::kEmergencyStop;
  left_alone_ |= halted_;
  return stopped;
}

}  // namespace slipstick
