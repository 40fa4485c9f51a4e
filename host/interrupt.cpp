#include "host/interrupt.h"

#include <csignal>

namespace slipstick {
namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interrupted = 0;

void on_signal(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void Interrupt::install() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGPIPE, SIG_IGN);
}

bool Interrupt::requested() {
  return interrupted != 0;
}

}  // namespace slipstick
