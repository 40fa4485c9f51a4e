#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/rng.h"
#include "drivers/clock.h"

namespace slipstick {

/// What a model does with a damaged line that Marlin's checksum, or the lack of one, lets through.
/// A ghost is the command of a line without its number, because a newline cut that off or it was
/// lost: then nothing is checked. kObeyGhosts obeys it if it is whole.
enum class Undetected : std::uint8_t { kRefuse, kObeyGhosts, kObey };

/// What a board throws away of the bytes behind a line that it refuses: what has arrived.
enum class Flush : std::uint8_t { kByChance, kAll, kNothing };

struct MarlinModelOptions {
  /// Marlin 2.1.2 and later drop the last two numbers without a word.
  bool swallows_duplicates = true;
  /// 2.0.8 sends no ok behind a Resend.
  bool ok_after_resend = true;
  Undetected undetected = Undetected::kRefuse;
  Flush flush = Flush::kByChance;
};

/// The front of Marlin's firmware as a host sees it: line check, command queue of one, replies.
/// Written from the protocol's description and independent of our sender. Executes nothing but
/// records everything.
class MarlinModel {
 public:
  MarlinModel(MarlinModelOptions options, std::uint64_t seed) : options_(options), rng_(seed) {}

  /// Tells which lines the host really sent, so that a damaged one that passes is noticed.
  void announce(std::string_view frames) {
    for (std::size_t at = 0; at < frames.size();) {
      const std::size_t end = std::min(frames.find('\n', at), frames.size());
      const std::string_view line = frames.substr(at, end - at);
      authentic_.emplace(line);
      const std::size_t blank = std::min(line.find(' '), line.size());
      const std::size_t star = std::min(line.find('*'), line.size());
      authentic_.emplace(line.substr(std::min(blank + 1, star), star - std::min(blank + 1, star)));
      at = end + 1;
    }
  }

  /// Bytes arrive at the receive buffer, which holds 127 and drops the rest.
  void hear(std::string_view bytes, Moment now) {
    received_ += bytes.substr(0, kReceiveBuffer - std::min(kReceiveBuffer, received_.size()));
    run(now);
  }

  /// What it says until `now`.
  std::string speak(Moment now) {
    run(now);
    std::string said;
    while (!due_.empty() && due_.front().at <= now) {
      said += due_.front().text;
      due_.pop_front();
    }
    return said;
  }

  /// When it will say or do something by itself.
  std::optional<Moment> next_event() const {
    std::optional<Moment> next;
    const auto consider = [&](Moment at) { next = next ? std::min(*next, at) : at; };
    if (!due_.empty()) consider(due_.front().at);
    if (!halted_ && received_.find_first_of("\r\n") != std::string::npos) consider(busy_until_);
    if (!halted_ && report_interval_ > Moment::zero()) consider(next_report_);
    return next;
  }

  /// A watchdog or a brown-out. Whether its `start` is heard is the wire's business.
  void reset(Moment now) {
    nozzle_on_ = bed_on_ = false;
    last_line_ = 0;
    received_.clear();
    report_interval_ = Moment::zero();
    busy_until_ = now;
    due_.clear();
    say(now, "start\nPowerUp\nMarlin 2.1.2\n");
  }

  /// Dead without a word: heaters stay as they are, as nobody looks after them.
  void halt() {
    halted_ = true;
    due_.clear();
  }

  /// A thermal fault, or M112: heaters off, a last word, silence.
  void kill(Moment now, std::string_view cause) {
    due_.clear();
    say(now, std::string(cause) + "Error:Printer halted. kill() called!\n");
    nozzle_on_ = bed_on_ = false;
    halted_ = true;
  }

  bool heats() const { return nozzle_on_ || bed_on_; }

  /// The texts of all numbered lines, in the order in which they were executed.
  const std::vector<std::string>& executed() const { return executed_; }
  /// Damaged lines that passed Marlin's checks.
  std::uint64_t undetected() const { return undetected_; }

 private:
  struct Said {
    Moment at;
    std::string text;
  };
  static constexpr std::size_t kReceiveBuffer = 127;

  void say(Moment at, std::string text) {
    const auto later = [](Moment moment, const Said& said) { return moment < said.at; };
    due_.insert(std::upper_bound(due_.begin(), due_.end(), at, later), {at, std::move(text)});
  }

  void run(Moment now) {
    while (!halted_ && busy_until_ <= now) {
      const std::size_t end = received_.find_first_of("\r\n");
      if (end == std::string::npos) break;
      const std::string line = received_.substr(0, end);
      received_.erase(0, end + 1);
      take_line(line, now);
    }
    while (!halted_ && report_interval_ > Moment::zero() && next_report_ <= now) {
      say(next_report_, " T:201.50 /200.00 B:60.01 /60.00 @:64 B@:12\n");
      next_report_ += report_interval_;
    }
  }

  void take_line(std::string_view line, Moment now) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.empty()) return;
    const bool passes = authentic_.contains(std::string(line));
    if (line.front() != 'N') return take_unnumbered(line, now);
    const std::size_t star = line.rfind('*');
    const std::int64_t number = std::strtoll(std::string(line.substr(1)).c_str(), nullptr, 10);
    const bool numbers = line.find("M110") != std::string_view::npos;
    if (!numbers && number != last_line_ + 1) {
      if (options_.swallows_duplicates && (number == last_line_ || number == last_line_ - 1))
        return;
      return refuse("Line Number is not Last Line Number+1", now);
    }
    if (star == std::string_view::npos) return refuse("No Checksum with line number", now);
    if (!sum_fits(line, star)) return refuse("checksum mismatch", now);
    if (!passes) {
      ++undetected_;
      if (options_.undetected != Undetected::kObey) return refuse("checksum mismatch", now);
    }
    last_line_ = number;
    std::string_view text = line.substr(0, star);
    text.remove_prefix(std::min(text.find_first_not_of("0123456789", 1), text.size()));
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (!numbers) executed_.emplace_back(text);
    execute(text, now);
  }

  static bool sum_fits(std::string_view line, std::size_t star) {
    int sum = 0;
    for (const char byte : line.substr(0, star)) sum ^= static_cast<unsigned char>(byte);
    return std::strtol(std::string(line.substr(star + 1)).c_str(), nullptr, 10) == sum;
  }

  void take_unnumbered(std::string_view line, Moment now) {
    if (line == "M112") return kill(now, "");
    const bool letter = line[0] == 'G' || line[0] == 'M' || line[0] == 'T';
    const std::size_t digits = std::min(line.find_first_not_of("0123456789", 1), line.size()) - 1;
    constexpr std::size_t kLongestCode = 3;
    const bool command = letter && digits > 0 && digits <= kLongestCode;
    if (command) {
      ++undetected_;
      const std::string_view text = line.substr(0, line.find('*'));
      const bool ghost = authentic_.contains(std::string(text));
      if (options_.undetected == Undetected::kObey ||
          (options_.undetected == Undetected::kObeyGhosts && ghost)) {
        if (text.starts_with("M110 N")) {
          last_line_ = std::strtoll(std::string(text.substr(6)).c_str(), nullptr, 10);
        } else {
          executed_.emplace_back(text);
        }
        return execute(text, now);
      }
    }
    say(now, "echo:Unknown command: \"" + std::string(line.substr(0, line.find('*'))) + "\"\nok\n");
  }

  /// Empties the receive buffer, or not quite: the rest of the bytes may still be under way.
  void refuse(const std::string& cause, Moment now) {
    const bool chance = options_.flush == Flush::kByChance;
    const auto dice = chance ? rng_.below(3) : static_cast<std::uint64_t>(options_.flush);
    if (dice == 0) received_.erase(0, rng_.below(received_.size() + 1));
    if (dice == 1) received_.clear();
    const std::string last = std::to_string(last_line_);
    const std::string next = std::to_string(last_line_ + 1);
    say(now, "Error:" + cause + ", Last Line: " + last + "\n");
    say(now, "Resend: " + next + "\n");
    if (options_.ok_after_resend) say(now, "ok\n");
  }

  void execute(std::string_view text, Moment now) {
    if (text.starts_with("G1 ")) move(text.substr(3));
    if (text == "G28") at_ = {0, 0, 0, at_[3]};
    if (text == "M114") {
      char report[96];
      std::snprintf(report, sizeof report, "X:%.2f Y:%.2f Z:%.2f E:%.2f Count X:0 Y:0 Z:0\n",
                    at_[0], at_[1], at_[2], at_[3]);
      say(now, report);
    }
    if (text.starts_with("M104 S")) nozzle_on_ = text != "M104 S0";
    if (text.starts_with("M140 S")) bed_on_ = text != "M140 S0";
    if (text == "M105") return say(now, "ok T:201.50 /200.00 B:60.01 /60.00 @:64 B@:12\n");
    if (text == "M115") {
      say(now,
          "FIRMWARE_NAME:Marlin 2.1.2 (Nov 22 2026) SOURCE_CODE_URL:x MACHINE_TYPE:Model\n"
          "Cap:AUTOREPORT_TEMP:1\nCap:EMERGENCY_PARSER:0\n");
    }
    if (text.starts_with("M155 S")) {
      report_interval_ = std::chrono::seconds(2);
      next_report_ = now + report_interval_;
    }
    if (text == "G28") return block(std::chrono::milliseconds(15'500), now);
    if (text.starts_with("G4")) return block(std::chrono::milliseconds(3'100), now);
    say(now, "ok\n");
  }

  /// Absolute places, relative extrusion: the jobs of the tests.
  void move(std::string_view words) {
    while (!words.empty()) {
      const std::size_t axis = std::string_view("XYZE").find(words.front());
      const double value = std::strtod(std::string(words.substr(1)).c_str(), nullptr);
      if (axis < 3) at_[axis] = value;
      if (axis == 3) at_[axis] += value;
      words.remove_prefix(std::min(words.find(' '), words.size()));
      words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
    }
  }

  void block(Moment duration, Moment now) {
    constexpr Moment kBusyInterval = std::chrono::seconds(2);
    busy_until_ = now + duration;
    for (Moment at = now + kBusyInterval; at < busy_until_; at += kBusyInterval) {
      say(at, "echo:busy: processing\n");
    }
    say(busy_until_, "ok\n");
  }

  MarlinModelOptions options_;
  Rng rng_;
  std::set<std::string> authentic_;
  std::string received_;
  std::deque<Said> due_;
  std::vector<std::string> executed_;
  std::int64_t last_line_ = 0;
  std::uint64_t undetected_ = 0;
  Moment busy_until_{};
  Moment report_interval_{};
  Moment next_report_{};
  bool halted_ = false;
  std::array<double, 4> at_{};  ///< X, Y, Z, E.
  bool nozzle_on_ = false;
  bool bed_on_ = false;
};

}  // namespace slipstick
