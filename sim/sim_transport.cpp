#include "sim/sim_transport.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"

namespace slipstick {

namespace {

constexpr double kBaudMax = 10'000'000;
constexpr double kSeedMax = 9e15;
constexpr std::size_t kFaultsMax = 64;

tl::unexpected<Error> bad_value(std::string_view name, std::string_view value,
                                std::string_view wanted) {
  return fail(ErrorCode::kInput, fmt::format("sim: option {}={}: give {}", name, value, wanted));
}

/// The number `text` if it is within the limits.
std::optional<double> number_in(const std::string& text, double low, double high) {
  const auto value = parse_number(text);
  if (!value || *value < low || *value > high) return std::nullopt;
  return value;
}

bool is_whole(double value) {
  return value == std::floor(value);
}

Result<void> add_faults(SimOptions& options, std::string_view list) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    const auto spec = FaultSpec::parse(list.substr(0, end));
    if (!spec) return fail(spec.error());
    if (options.printer.faults.size() == kFaultsMax) {
      return fail(ErrorCode::kInput, fmt::format("sim: more than {} faults", kFaultsMax));
    }
    options.printer.faults.push_back(*spec);
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return {};
}

Result<void> apply(SimOptions& options, const std::string& name, const std::string& value) {
  if (name == "baud") {
    const auto baud = number_in(value, 0, kBaudMax);
    if (!baud || !is_whole(*baud)) return bad_value(name, value, "bits per second, 0 for USB");
    options.printer.baud = static_cast<int>(*baud);
  } else if (name == "corrupt") {
    const auto share = number_in(value, 0, 1);
    if (!share) return bad_value(name, value, "the share of bytes damaged, 0 to 1");
    options.printer.corrupt = *share;
  } else if (name == "seed") {
    const auto seed = number_in(value, 0, kSeedMax);
    if (!seed || !is_whole(*seed)) return bad_value(name, value, "a whole number");
    options.printer.seed = static_cast<std::uint64_t>(*seed);
  } else if (name == "realtime") {
    if (value != "0" && value != "1") return bad_value(name, value, "0 or 1");
    options.realtime = value == "1";
  } else if (name == "fault") {
    return add_faults(options, value);
  } else if (name == "firmware") {
    const auto personality = find_personality(value);
    if (!personality) return bad_value(name, value, "one of " + personality_names());
    options.printer.personality = *personality;
  } else {
    return fail(
        ErrorCode::kInput,
        fmt::format("sim: no option {}: there are baud, corrupt, fault, firmware, realtime, seed",
                    name));
  }
  return {};
}

tl::unexpected<Error> unplugged() {
  return fail(ErrorCode::kUnavailable, "sim: the cable is out");
}

tl::unexpected<Error> cancelled() {
  return fail(ErrorCode::kCancelled, "sim: was shut down");
}

}  // namespace

Result<SimOptions> sim_options(const std::map<std::string, std::string>& options) {
  SimOptions result;
  for (const auto& [name, value] : options) {
    if (auto applied = apply(result, name, value); !applied) return fail(applied.error());
  }
  return result;
}

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
