#include "host/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace slipstick {
namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kRedraw{100};

std::string duration_text(double seconds) {
  const auto total = static_cast<long>(std::max(seconds, 0.0));
  if (total >= 3600) return fmt::format("{}h{:02}m", total / 3600, total / 60 % 60);
  return fmt::format("{}m{:02}s", total / 60, total % 60);
}

}  // namespace

Progress::Progress(std::string_view verb, int layers)
    : verb_(verb), layers_(std::max(layers, 1)), visible_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputc('\n', stderr);
}

void Progress::show(int done, double height, double seconds_left) {
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || (done < layers_ && now - last_ < kRedraw)) return;
  last_ = now;
  if (seconds_left < 0 && done > 0) {
    const std::chrono::duration<double> passed = now - start_;
    seconds_left = passed.count() * (layers_ - done) / done;
  }
  const int filled = kBarWidth * std::min(done, layers_) / layers_;
  fmt::print(stderr, "\r{} [{:<{}}] layer {}/{}  {:.2f} mm  {} left \033[K", verb_,
             std::string(static_cast<std::size_t>(filled), '#'), kBarWidth, done, layers_, height,
             duration_text(seconds_left));
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace slipstick
