#include "host/serve/printer_worker.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <ctime>

#include "drivers/marlin/interjection.h"
#include "drivers/marlin/safe_stop.h"
#include "drivers/open_transport.h"
#include "host/process_memory.h"
#include "host/serve/pause_layers.h"
#include "host/serve/print_task.h"
#include "host/settings_changes_text.h"

namespace slipstick {
namespace {

constexpr std::chrono::seconds kTellPatience{5};

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
    const auto told = tell_printer(worker->port_, kCoolDownBytes);
    if (!told)
      spdlog::error("a print was cut off; its heaters may be on: {}", told.error().message);
  }
  worker->thread_ = std::thread([raw = worker.get()] { raw->run(); });
  return worker;
}

PrinterWorker::PrinterWorker(Options options, Store store, StatusBoard& board, EventLog& events)
    : options_(std::move(options)),
      serial_log_(std::make_shared<SerialLog>(options_.data)),
      store_(std::move(store)),
      reporter_(board, events),
      port_(options_.port),
      defaults_(options_.defaults) {}

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
  return tell_printer(port(), kEmergencyStop);
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
  give_back_freed_memory();
}

// An emergency stop may have been wished for when nobody heeded it any more; twice does no harm.
void PrinterWorker::stop_again() {
  const auto told = tell_printer(port(), kEmergencyStop);
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
  const auto spec = job_spec_from_text(job.spec, defaults());
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
                       port(),
                       store_.journal_of(job.id),
                       take_up,
                       timeline,
                       serial_log_};
  return run_print_task(task, *current(),
                        {[this](int layers) { reporter_.job_is_of(layers); },
                         [this](PrintedLayer layer) { reporter_.layer_began(std::move(layer)); },
                         [this](double share) { reporter_.completion(share); },
                         [&](int layer) { return pauses_before(job.id, layer); }});
}

Store::Ending PrinterWorker::ending(const Result<std::string>& printed) {
  if (printed) return {JobState::kDone, "", *printed};
  const std::string& message = printed.error().message;
  if (printed.error().code != ErrorCode::kCancelled) return {JobState::kFailed, message, ""};
  const std::lock_guard lock(mutex_);
  if (stopping_) return {JobState::kInterrupted, "slipstick was stopped: " + message, ""};
  return {JobState::kCancelled, message, ""};
}

// Looked up when the layer comes: until then it may be changed.
bool PrinterWorker::pauses_before(std::int64_t job, int layer) {
  const auto stored = store_.job(job);
  if (!stored) spdlog::error("job {}: {}", job, stored.error().message);
  return stored && *stored && std::ranges::binary_search(pauses_of(**stored), layer);
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
