// Preloaded: gives pseudo-terminals the modem lines that serial ports have, as a kernel's driver
// switches them, and counts how often DTR fell.
#include <asm/termbits.h>
#include <dlfcn.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdarg>

namespace {

using Ioctl = int (*)(int, unsigned long, void*);

std::atomic<int> lines{TIOCM_DTR | TIOCM_RTS};  // as an opened port has them
std::atomic<int> falls{0};

void set(int now) {
  if ((lines.exchange(now) & ~now & TIOCM_DTR) != 0) ++falls;
}

}  // namespace

extern "C" {

/// How often DTR was switched off, in this process.
int slipstick_dtr_falls() {
  return falls;
}

int ioctl(int fd, unsigned long request, ...) noexcept {
  va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  int* bits = static_cast<int*>(argument);
  switch (request) {
    case TIOCMGET:
      *bits = lines;
      return 0;
    case TIOCMSET:
      set(*bits);
      return 0;
    case TIOCMBIS:
      set(lines | *bits);
      return 0;
    case TIOCMBIC:
      set(lines & ~*bits);
      return 0;
    case TCGETS2:
    case TCSETS2:
      // What any baud rate is set with: umockdev does not know it, the terminal behind it does.
      return static_cast<int>(::syscall(SYS_ioctl, fd, request, argument));
    default:
      break;
  }
  // The next in line is umockdev's.
  static const auto next = reinterpret_cast<Ioctl>(::dlsym(RTLD_NEXT, "ioctl"));
  return next(fd, request, argument);
}
}
