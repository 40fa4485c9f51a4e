#pragma once

#include <optional>

namespace slipstick {

/// When a print will be over, from how fast it has come along since the printer was hot.
///
/// Seconds count from the beginning of the print.
class TimeLeft {
 public:
  /// Before so much is done, nothing is known: a file begins with heating.
  static constexpr double kBegun = 0.01;
  static constexpr double kToldFrom = 0.02;

  /// `completion`, 0 to 1, was reached at `seconds`.
  void moved(double seconds, double completion) {
    if (!began_ && completion >= kBegun) began_ = Mark{seconds, completion};
    now_ = {seconds, completion};
  }
  /// Nothing went on until `seconds`: a pause says nothing of the pace.
  void stood(double seconds) {
    if (began_) began_->seconds += seconds - now_.seconds;
    now_.seconds = seconds;
  }

  /// Seconds.
  [[nodiscard]] std::optional<double> seconds() const {
    if (!began_ || now_.completion < kToldFrom) return std::nullopt;
    const double done = now_.completion - began_->completion;
    if (done <= 0) return std::nullopt;
    return (now_.seconds - began_->seconds) * (1 - now_.completion) / done;
  }

 private:
  struct Mark {
    double seconds = 0;
    double completion = 0;
  };
  std::optional<Mark> began_;
  Mark now_;
};

}  // namespace slipstick
