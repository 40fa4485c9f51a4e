#include "host/interrupt.h"

#include <csignal>

namespace slipstick {
namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interrupts = 0;

void on_signal(int signal) {
  interrupts = interrupts + 1;
  if (interrupts >= 2) std::signal(signal, SIG_DFL);
}

}  // namespace

void Interrupt::install() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGPIPE, SIG_IGN);
}

bool Interrupt::requested() {
  return interrupts > 0;
}

bool Interrupt::urgent() {
  return interrupts > 1;
}

}  // namespace slipstick
