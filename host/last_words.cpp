#include "host/last_words.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <string>
#include <string_view>

#include "core/base/check.h"
#include "drivers/marlin/safe_stop.h"
#include "host/print_journal.h"

namespace slipstick {
namespace {

constexpr std::array<int, 5> kFatal{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// A signal handler has nothing else to look at.
std::atomic<int> printer{-1};
std::atomic<int> journal_file{-1};
std::array<char, 32> journal_end;  // what is written there
std::atomic<std::size_t> journal_end_size{0};

void write_all(int descriptor, std::string_view bytes) {
  const ssize_t ignored = ::write(descriptor, bytes.data(), bytes.size());
  static_cast<void>(ignored);
}

void say() {
  const int descriptor = printer.exchange(-1);
  if (descriptor < 0) return;
  write_all(descriptor, kSafeStopBytes);
  const int journal = journal_file.exchange(-1);
  if (journal >= 0) write_all(journal, {journal_end.data(), journal_end_size});
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

LastWords::LastWords(int descriptor, int journal) {
  if (descriptor < 0) return;
  const std::string end = end_record(JournalEnd::kStopped);
  SLIPSTICK_CHECK(end.size() <= journal_end.size());
  std::ranges::copy(end, journal_end.begin());
  journal_end_size = end.size();
  journal_file = journal;
  SLIPSTICK_CHECK(printer.exchange(descriptor) < 0);
  set_check_hook(say);
  handle_fatal(on_fatal);
}

LastWords::~LastWords() {
  if (printer.exchange(-1) < 0) return;
  journal_file = -1;
  set_check_hook(nullptr);
  handle_fatal(SIG_DFL);
}

}  // namespace slipstick
