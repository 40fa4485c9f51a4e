#include "core/base/check.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace slipstick {
namespace {

std::atomic<CheckHook> check_hook{nullptr};

}  // namespace

void set_check_hook(CheckHook hook) noexcept {
  check_hook = hook;
}

void check_failed(const char* condition, const char* file, int line) noexcept {
  if (const CheckHook hook = check_hook.exchange(nullptr)) hook();
  std::fprintf(stderr, "slipstick: internal error: %s does not hold (%s:%d)\n", condition, file,
               line);
  std::abort();
}

}  // namespace slipstick
