// A program that crashes says something first.
#include "host/last_words.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "core/base/check.h"
#include "drivers/marlin/safe_stop.h"
#include "drivers/unique_fd.h"
#include "host/journal.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;

namespace {

// What comes out of `fd` until all who can write are gone.
std::string all_of(int fd) {
  std::string all;
  char bytes[256];
  for (ssize_t got = 0; (got = ::read(fd, bytes, sizeof bytes)) > 0;)
    all.append(bytes, static_cast<std::size_t>(got));
  return all;
}

}  // namespace

TEST_CASE("A crash turns the heaters off, and the journal tells that the motors are off") {
  const int signal = GENERATE(SIGSEGV, SIGABRT, SIGFPE);
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.journal";
  const auto journal = Journal::create(path, {});
  REQUIRE(journal);
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  const UniqueFd printer(ends[0]);
  UniqueFd host(ends[1]);

  const pid_t child = ::fork();
  if (child == 0) {
    const LastWords words(host.get(), journal->descriptor());
    std::raise(signal);
    ::_exit(0);
  }
  host.reset();
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);

  CHECK(WIFSIGNALED(status));
  CHECK(all_of(printer.get()) == kSafeStopBytes);
  CHECK(read_journal(path)->end == JournalEnd::kStopped);
}

TEST_CASE("Who ends in good order says nothing") {
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  const UniqueFd printer(ends[0]);
  UniqueFd host(ends[1]);

  { const LastWords words(host.get(), -1); }

  host.reset();
  CHECK(all_of(printer.get()).empty());
}
