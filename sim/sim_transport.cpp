#include "sim/sim_transport.h"

#include <algorithm>
#include <array>

namespace slipstick {

namespace {

tl::unexpected<Error> unplugged() {
  return fail(ErrorCode::kUnavailable, "sim: the cable is out");
}

tl::unexpected<Error> cancelled() {
  return fail(ErrorCode::kCancelled, "sim: was shut down");
}

}  // namespace

SimTransport::SimTransport(const SimOptions& options, const Planner::Sink& sink)
    : printer_(options.printer, sink), realtime_(options.realtime) {}

Moment SimTransport::steady_now() const {
  return std::chrono::duration_cast<Moment>(std::chrono::steady_clock::now() - started_);
}

void SimTransport::advance_to(Moment to) {
  printer_.advance(to);
  clock_.advance_to(printer_.now());
}

void SimTransport::pass_time(Moment deadline) {
  Moment next = deadline;
  if (const auto m = printer_.next_event()) next = std::min(next, *m);
  if (const auto m = printer_.output_at()) next = std::min(next, *m);
  next = std::max(next, printer_.now());
  if (realtime_) {
    std::unique_lock lock(mutex_);
    woken_.wait_until(lock, started_ + next, [this] { return shut_down_.load(); });
    next = std::max(next, std::min(deadline, steady_now()));
  }
  advance_to(next);
}

Result<std::size_t> SimTransport::read_some(std::span<char> buffer,
                                            std::chrono::microseconds patience) {
  if (realtime_) advance_to(std::max(printer_.now(), steady_now()));
  const Moment deadline = printer_.now() + patience;
  while (!shut_down_) {
    if (!printer_.plugged()) return unplugged();
    if (const std::size_t count = printer_.take(buffer); count > 0) return count;
    if (printer_.now() >= deadline) {
      return fail(ErrorCode::kTimedOut, "sim: the printer said nothing");
    }
    pass_time(deadline);
  }
  return cancelled();
}

Result<std::size_t> SimTransport::write_some(std::string_view bytes,
                                             std::chrono::microseconds patience) {
  if (realtime_) advance_to(std::max(printer_.now(), steady_now()));
  const Moment deadline = printer_.now() + patience;
  while (!shut_down_) {
    if (!printer_.plugged()) return unplugged();
    const std::size_t room = kTtyBuffer - std::min(kTtyBuffer, printer_.unread());
    if (const std::size_t count = std::min(room, bytes.size()); count > 0) {
      printer_.receive(bytes.substr(0, count), printer_.now());
      return count;
    }
    if (printer_.now() >= deadline) {
      return fail(ErrorCode::kTimedOut, "sim: the printer does not read");
    }
    pass_time(deadline);
  }
  return cancelled();
}

Result<void> SimTransport::write_all(std::string_view bytes, std::chrono::microseconds patience) {
  const Moment deadline = printer_.now() + patience;
  while (!bytes.empty()) {
    const auto count = write_some(bytes, deadline - printer_.now());
    if (!count) return fail(count.error());
    bytes.remove_prefix(*count);
  }
  return {};
}

void SimTransport::run_down(Moment most) {
  const Moment deadline = printer_.now() + most;
  const auto moves = [this] {
    return !printer_.machine().halted && !printer_.machine().planner.idle();
  };
  std::array<char, 256> unheard{};
  while (!shut_down_ && printer_.now() < deadline && moves()) {
    // What it says meanwhile would be due again and again, and no time would pass.
    static_cast<void>(printer_.take(unheard));
    pass_time(deadline);
  }
}

void SimTransport::shut_down() noexcept {
  {
    const std::lock_guard lock(mutex_);
    shut_down_ = true;
  }
  woken_.notify_all();
}

}  // namespace slipstick
