#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "drivers/clock.h"

namespace slipstick {

class Printer;

/// When a fault is there: from a moment since power on, or from when the board has taken so many
/// lines, to another moment or for good.
struct FaultWhen {
  std::optional<Moment> from;
  std::optional<std::int64_t> line;  ///< If there is no `from`.
  std::optional<Moment> lasts;       ///< Nothing: for good.
};

/// One thing that goes wrong with a printer or its cable. What is not overridden stays as it is.
///
/// A fault that changes bytes does so while it is `active`; one that happens to the printer strikes
/// when it begins, and relents when it is over.
class Fault {
 public:
  explicit Fault(const FaultWhen& when)
      : begins_(when.from), line_(when.line), lasts_(when.lasts) {}
  virtual ~Fault() = default;
  Fault(const Fault&) = delete;
  Fault& operator=(const Fault&) = delete;

  /// Lets time come to `printer`'s: strikes and relents where that is due.
  void see(Printer& printer);
  /// Ends it now, whatever it was to last.
  void end(Printer& printer);
  /// Whether nothing more comes of it.
  [[nodiscard]] bool over() const { return over_ || (struck_ && momentary()); }
  /// When `see` must be called though nothing happens before.
  [[nodiscard]] std::optional<Moment> next_at() const;

  /// What the host sends at `now`, as it reaches the board.
  [[nodiscard]] virtual std::string to_board(std::string bytes, Moment) { return bytes; }
  /// Whole lines that the board says at `now`, as they reach the host.
  [[nodiscard]] virtual std::string to_host(std::string text, Moment) { return text; }
  /// How much later than they should those lines are there.
  [[nodiscard]] virtual Moment delay(Moment) const { return Moment(0); }

  /// How often it did harm so far.
  [[nodiscard]] std::int64_t count() const { return count_; }

 protected:
  [[nodiscard]] bool active(Moment now) const {
    return !over_ && begins_ && now >= *begins_ && (!lasts_ || now < *begins_ + *lasts_);
  }
  void harm() { ++count_; }

 private:
  virtual void strike(Printer&) {}
  virtual void relent(Printer&) {}
  /// Whether it is done once it has struck.
  [[nodiscard]] virtual bool momentary() const { return false; }

  std::optional<Moment> begins_;
  std::optional<std::int64_t> line_;
  std::optional<Moment> lasts_;
  bool struck_ = false;
  bool over_ = false;
  std::int64_t count_ = 0;
};

}  // namespace slipstick
