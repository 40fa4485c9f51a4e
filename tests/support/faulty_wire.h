#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/rng.h"
#include "drivers/clock.h"

namespace slipstick {

/// What may happen to bytes on their way. Shares are chances, 0 to 1.
struct WireFaults {
  double damage = 0;       ///< Per byte: changed, lost, doubled or followed by another.
  double lost_oks = 0;     ///< Per line that is an `ok` and nothing else.
  double doubled_oks = 0;  ///< The same.
  Moment latency = std::chrono::milliseconds(1);
  Moment jitter = Moment::zero();  ///< Up to this much more, for each line anew.
  double stalls = 0;               ///< Per line: it and all behind it come up to 3 s late.
};

/// One direction of a cable: bytes in, time, bytes out, in order.
class FaultyWire {
 public:
  FaultyWire(const WireFaults& faults, std::uint64_t seed) : faults_(faults), rng_(seed) {}

  void push(std::string_view bytes, Moment now) {
    while (!bytes.empty()) {
      const std::size_t length = std::min(bytes.find('\n'), bytes.size() - 1) + 1;
      push_line(bytes.substr(0, length), now);
      bytes.remove_prefix(length);
    }
  }

  /// What has arrived by `now`.
  std::string take(Moment now) {
    std::string arrived;
    while (!under_way_.empty() && under_way_.front().at <= now) {
      arrived += under_way_.front().bytes;
      under_way_.pop_front();
    }
    return arrived;
  }

  std::optional<Moment> next_at() const {
    return under_way_.empty() ? std::nullopt : std::optional(under_way_.front().at);
  }

  /// Nothing gets through while it is cut.
  void cut(bool is_cut) {
    cut_ = is_cut;
    if (cut_) under_way_.clear();
  }
  bool is_cut() const { return cut_; }

  std::uint64_t faults() const { return count_; }

 private:
  struct Chunk {
    Moment at;
    std::string bytes;
  };

  bool happens(double share) {
    const bool does = share > 0 && rng_.unit() < share;
    if (does) ++count_;
    return does;
  }

  void push_line(std::string_view line, Moment now) {
    if (cut_) return;
    const bool ok = line == "ok\n";
    if (ok && happens(faults_.lost_oks)) return;
    std::string bytes = damaged(line);
    if (ok && happens(faults_.doubled_oks)) bytes += "ok\n";
    Moment at = now + faults_.latency;
    if (faults_.jitter > Moment::zero()) {
      at += Moment(
          static_cast<Moment::rep>(static_cast<double>(faults_.jitter.count()) * rng_.unit()));
    }
    if (happens(faults_.stalls)) at += std::chrono::milliseconds(rng_.below(3000));
    last_ = std::max(last_, at);
    if (!bytes.empty()) under_way_.push_back({last_, std::move(bytes)});
  }

  std::string damaged(std::string_view bytes) {
    if (faults_.damage <= 0) return std::string(bytes);
    std::string passed;
    for (const char byte : bytes) {
      if (!happens(faults_.damage)) {
        passed += byte;
        continue;
      }
      switch (rng_.below(5)) {
        case 0:
          passed += static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << rng_.below(8)));
          break;
        case 1:
          passed += static_cast<char>(rng_.below(256));
          break;
        case 2:
          passed.append(2, byte);
          break;
        case 3:
          passed += byte;
          passed += static_cast<char>(rng_.below(256));
          break;
        default:
          break;
      }
    }
    return passed;
  }

  WireFaults faults_;
  Rng rng_;
  std::deque<Chunk> under_way_;
  Moment last_{};
  std::uint64_t count_ = 0;
  bool cut_ = false;
};

}  // namespace slipstick
