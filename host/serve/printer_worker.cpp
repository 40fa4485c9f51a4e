#include "host/serve/printer_worker.h"

#include <spdlog/spdlog.h>

#include <ctime>

#include "drivers/marlin/interjection.h"
#include "drivers/marlin/safe_stop.h"
#include "drivers/open_transport.h"
#include "host/serve/idle_connection.h"
#include "host/serve/print_task.h"
#include "host/settings_changes_text.h"

namespace slipstick {
namespace {

constexpr std::chrono::seconds kTellPatience{5};
/// Where the printer is not there, or does not answer.
constexpr std::chrono::seconds kBetweenConnections{5};

std::int64_t unix_now() {
  return static_cast<std::int64_t>(std::time(nullptr));
}

// Says `bytes` to a printer that is not being printed on. The simulated one is there only while it
// prints.
Result<void> tell_printer(const std::string& port, std::string_view bytes) {
  const auto address = parse_transport_address(port);
  if (!address) return fail(address.error());
  if (address->kind == TransportKind::kSim) return {};
  const auto transport = open_transport(*address);
  if (!transport) return fail(transport.error());
  return (*transport)->write_all(bytes, kTellPatience);
}

}  // namespace

Result<std::unique_ptr<PrinterWorker>> PrinterWorker::start(Options options, StatusBoard& board,
                                                            EventLog& events) {
  auto store = Store::open(options.data);
  if (!store) return fail(store.error());
  const auto interrupted = store->recover(unix_now());
  if (!interrupted) return fail(interrupted.error());
  std::unique_ptr<PrinterWorker> worker(
      new PrinterWorker(std::move(options), std::move(*store), board, events));
  if (*interrupted > 0) {
    const auto told = tell_printer(worker->options_.port, kCoolDownBytes);
    if (!told)
      spdlog::error("a print was cut off; its heaters may be on: {}", told.error().message);
  }
  worker->thread_ = std::thread([raw = worker.get()] { raw->run(); });
  return worker;
}

PrinterWorker::PrinterWorker(Options options, Store store, StatusBoard& board, EventLog& events)
    : options_(std::move(options)), store_(std::move(store)), reporter_(board, events) {}

PrinterWorker::~PrinterWorker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    if (control_) control_->cancel();
    if (idle_) idle_->cancel();
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void PrinterWorker::wake() {
  {
    const std::lock_guard lock(mutex_);
    look_again_ = true;
    left_alone_ = false;
  }
  changed_.notify_all();
}

bool PrinterWorker::pause() {
  const auto control = current();
  return control && control->pause();
}

bool PrinterWorker::resume() {
  const auto control = current();
  return control && control->resume();
}

Result<void> PrinterWorker::say(const std::vector<std::string>& commands) {
  const std::lock_guard lock(mutex_);
  const auto control = control_ ? control_ : idle_;
  if (!control) return fail(ErrorCode::kPrinter, "no printer is connected");
  std::vector<Line> lines;
  for (const std::string& command : commands) {
    auto line = control_ ? interjection(command) : command_line(command);
    if (!line) return fail(line.error());
    lines.push_back(*std::move(line));
  }
  return control->interject(lines);
}

bool PrinterWorker::cancel(std::int64_t id) {
  const std::lock_guard lock(mutex_);
  if (!control_ || job_ != id) return false;
  control_->cancel();
  return true;
}

Result<void> PrinterWorker::emergency_stop() {
  const auto control = [this] {
    const std::lock_guard lock(mutex_);
    // What was asked for before must not wake the printer again.
    left_alone_ = true;
    look_again_ = false;
    take_up_.reset();
    return control_ ? control_ : idle_;
  }();
  if (control) control->emergency_stop();
  if (control && control->is_heeded()) return {};
  return tell_printer(options_.port, kEmergencyStop);
}

bool PrinterWorker::take_up(std::int64_t id, Consent consent) {
  {
    const std::lock_guard lock(mutex_);
    if (control_) return false;
    take_up_ = TakingUp{id, consent};
    look_again_ = true;
    left_alone_ = false;
  }
  changed_.notify_all();
  return true;
}

std::optional<PrinterWorker::TakingUp> PrinterWorker::asked_to_take_up() {
  const std::lock_guard lock(mutex_);
  return std::exchange(take_up_, std::nullopt);
}

void PrinterWorker::run() {
  const auto occupied = store_.bed_occupied();
  reporter_.bed(occupied && *occupied);
  while (wait_for_work()) {
    while (true) {
      const auto printed = print_next();
      if (!printed) spdlog::error("{}", printed.error().message);
      if (!printed || !*printed) break;
    }
  }
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
  const auto address = parse_transport_address(options_.port);
  if (!address || address->kind == TransportKind::kSim) return false;
  const auto cut_off = store_.print_is_cut_off();
  const std::lock_guard lock(mutex_);
  return cut_off && !*cut_off && !left_alone_ && !look_again_ && !stopping_;
}

// Until there is work. Whether the connection was there until then.
Result<void> PrinterWorker::stay_idle() {
  auto transport = open_transport(*parse_transport_address(options_.port));
  if (!transport) {
    reporter_.connected(false, transport.error().message);
    return fail(transport.error());
  }
  const auto control = begin_idle();
  const SteadyClock clock;
  const auto how = stay_connected(**transport, clock, *control, [this] { return is_called(); });
  const bool stopped = end_idle();
  transport->reset();
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

// False if there is nothing to be printed now.
Result<bool> PrinterWorker::print_next() {
  if (const auto what = asked_to_take_up()) return print_again(*what);
  const auto occupied = store_.bed_occupied();
  if (!occupied) return fail(occupied.error());
  reporter_.bed(*occupied);
  if (*occupied) return false;
  const auto job = store_.next_job();
  if (!job) return fail(job.error());
  if (!*job) return false;
  // Whoever cancels the job now finds it either still queued or already under way.
  const auto control = begin((*job)->id);
  if (!control) return false;
  const auto claimed = store_.claim_job((*job)->id, unix_now());
  if (claimed && *claimed) {
    print(**job, std::nullopt);
  } else {
    over();
  }
  if (!claimed) return fail(claimed.error());
  const std::lock_guard lock(mutex_);
  return !stopping_;
}

// A print that cannot be taken up is still what it was: it may be tried in another way.
Result<bool> PrinterWorker::print_again(const TakingUp& what) {
  const auto job = store_.job(what.job);
  if (!job) return fail(job.error());
  if (!*job || !begin(what.job)) return false;
  const auto claimed = store_.claim_again(what.job);
  if (claimed && *claimed) {
    print(**job, what.consent);
  } else {
    over();
  }
  if (!claimed) return fail(claimed.error());
  const std::lock_guard lock(mutex_);
  return !stopping_;
}

void PrinterWorker::print(const StoredJob& job, std::optional<Consent> take_up) {
  reporter_.job_began(job.id, job.file_name);
  const auto came = printed(job, take_up);
  const bool refused = take_up && !came && came.error().code == ErrorCode::kInput;
  const Store::Ending came_to =
      refused ? Store::Ending{JobState::kInterrupted, came.error().message, ""} : ending(came);
  const bool emergency = over() == PrintControl::Wish::kEmergencyStop;
  const bool stopped = emergency || came_to.state == JobState::kFailed;
  if (emergency) stop_again();
  if (const auto ok = store_.end_job(job.id, came_to, unix_now()); !ok) {
    spdlog::error("job {}: {}", job.id, ok.error().message);
  }
  reporter_.job_came_to(job.id, name_of(came_to.state), came_to.message);
  reporter_.job_ended(stopped ? PrinterActivity::kStopped : PrinterActivity::kIdle,
                      came_to.message);
}

// An emergency stop may have been wished for when nobody heeded it any more; twice does no harm.
void PrinterWorker::stop_again() const {
  const auto told = tell_printer(options_.port, kEmergencyStop);
  if (!told) spdlog::error("emergency stop: {}", told.error().message);
}

Result<void> PrinterWorker::switch_power_on(const StoredJob& job) const {
  if (!options_.power_on) return {};
  const auto told = options_.power_on->tell("power-on", {{"job", job.id}, {"file", job.file_name}});
  // An error of the user's: a print that was to be taken up can still be.
  if (!told) return fail(ErrorCode::kInput, "the power supply: " + told.error().message);
  return {};
}

std::shared_ptr<SettingsTimeline> PrinterWorker::timeline_of(std::int64_t id) {
  const std::lock_guard lock(mutex_);
  return job_ == id ? timeline_ : nullptr;
}

Result<std::shared_ptr<SettingsTimeline>> PrinterWorker::begin_timeline(const StoredJob& job,
                                                                        const JobSpec& spec) {
  const auto settings = load_settings(spec.settings);
  if (!settings) return fail(settings.error());
  auto timeline = std::make_shared<SettingsTimeline>(*settings);
  const auto changes = parse_changes(job.changes);
  if (!changes) spdlog::error("job {}: what was changed in it is damaged", job.id);
  // Those that were promised for layers that the print did not reach; the journal tells the others.
  const auto ok = timeline->take_up(changes.value_or(std::vector<SettingsChange>()), 0);
  if (!ok) return fail(ok.error());
  timeline->go_on();
  const std::lock_guard lock(mutex_);
  timeline_ = timeline;
  return timeline;
}

Result<std::string> PrinterWorker::printed(const StoredJob& claimed,
                                           std::optional<Consent> take_up) {
  // Its settings may have been changed until it was claimed.
  const auto stored = store_.job(claimed.id);
  if (!stored) return fail(stored.error());
  const StoredJob& job = *stored ? **stored : claimed;
  const auto spec = job_spec_from_text(job.spec, options_.defaults);
  if (!spec) return fail(spec.error());
  const auto name = FileName::from(job.file_name);
  if (!name) return fail(name.error());
  if (const auto on = switch_power_on(job); !on) return fail(on.error());
  std::shared_ptr<SettingsTimeline> timeline;
  if (!name->is_gcode()) {
    const auto begun = begin_timeline(job, *spec);
    if (!begun) return fail(begun.error());
    timeline = *begun;
  }
  const PrintTask task{store_.path_of(job.file, job.extension).string(),
                       job.file_name,
                       name->is_gcode(),
                       *spec,
                       options_.port,
                       store_.journal_of(job.id),
                       take_up,
                       timeline};
  return run_print_task(task, *current(),
                        {[this](int layers) { reporter_.job_is_of(layers); },
                         [this](PrintedLayer layer) { reporter_.layer_began(std::move(layer)); },
                         [this](double share) { reporter_.completion(share); }});
}

Store::Ending PrinterWorker::ending(const Result<std::string>& printed) {
  if (printed) return {JobState::kDone, "", *printed};
  const std::string& message = printed.error().message;
  if (printed.error().code != ErrorCode::kCancelled) return {JobState::kFailed, message, ""};
  const std::lock_guard lock(mutex_);
  if (stopping_) return {JobState::kInterrupted, "slipstick was stopped: " + message, ""};
  return {JobState::kCancelled, message, ""};
}

// Nothing if the worker is to end.
std::shared_ptr<PrintControl> PrinterWorker::begin(std::int64_t id) {
  const std::lock_guard lock(mutex_);
  if (stopping_ || left_alone_) return nullptr;
  job_ = id;
  control_ = std::make_shared<PrintControl>(
      PrintControl::Listeners{[this](const SenderEvent& event) { reporter_.heard(event); },
                              [this](SenderState, const StreamFigures& figures) {
                                reporter_.turn(current()->wish(), figures);
                              }});
  return control_;
}

// No request reaches the job any more. What was last wished of it.
PrintControl::Wish PrinterWorker::over() {
  const std::lock_guard lock(mutex_);
  if (timeline_) timeline_->end_at(0);
  timeline_.reset();
  job_ = 0;
  return std::exchange(control_, nullptr)->wish();
}

std::shared_ptr<PrintControl> PrinterWorker::current() {
  const std::lock_guard lock(mutex_);
  return control_;
}

}  // namespace slipstick
