#include "host/interrupt.h"

#include <csignal>

namespace slipstick {
namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interrupts = 0;
volatile std::sig_atomic_t paused = 0;

void on_signal(int signal) {
  interrupts = interrupts + 1;
  if (interrupts >= 2) std::signal(signal, SIG_DFL);
}

void on_stop(int /*signal*/) {
  paused = 1 - paused;
}

}  // namespace

void Interrupt::install() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

void Interrupt::pause_by_terminal() {
  std::signal(SIGTSTP, on_stop);
}

bool Interrupt::pause() {
  return paused != 0;
}

void Interrupt::forget_pause() {
  paused = 0;
}

bool Interrupt::requested() {
  return interrupts > 0;
}

bool Interrupt::urgent() {
  return interrupts > 1;
}

}  // namespace slipstick
