#include "host/last_words.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

#include "core/base/check.h"
#include "drivers/marlin/safe_stop.h"

namespace slipstick {
namespace {

constexpr std::array<int, 5> kFatal{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// A signal handler has nothing else to look at.
std::atomic<int> printer{-1};

void say() {
  const int descriptor = printer.exchange(-1);
  if (descriptor < 0) return;
  const ssize_t ignored = ::write(descriptor, kSafeStopBytes.data(), kSafeStopBytes.size());
  static_cast<void>(ignored);
}

void on_fatal(int signal) {
  say();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void handle_fatal(void (*handler)(int)) {
  for (const int signal : kFatal) std::signal(signal, handler);
}

}  // namespace

LastWords::LastWords(int descriptor) {
  if (descriptor < 0) return;
  SLIPSTICK_CHECK(printer.exchange(descriptor) < 0);
  set_check_hook(say);
  handle_fatal(on_fatal);
}

LastWords::~LastWords() {
  if (printer.exchange(-1) < 0) return;
  set_check_hook(nullptr);
  handle_fatal(SIG_DFL);
}

}  // namespace slipstick
