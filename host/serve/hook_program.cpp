#include "host/serve/hook_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "drivers/unique_fd.h"

namespace slipstick {
namespace {

tl::unexpected<Error> failed(const std::string& program, std::string_view why) {
  return fail(ErrorCode::kUnavailable, fmt::format("{}: {}", program, why));
}

// A file without a name: whoever does not read it holds nobody up.
UniqueFd file_of(std::string_view input) {
  UniqueFd file(::memfd_create("hook", MFD_CLOEXEC));
  if (!file.valid() || ::write(file.get(), input.data(), input.size()) != ssize_t(input.size()) ||
      ::lseek(file.get(), 0, SEEK_SET) != 0)
    return UniqueFd();
  return file;
}

// With nothing of ours open or blocked.
int spawn(pid_t& process, const std::string& program, std::string argument, int input) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  // A group of its own: its children are killed with it, and a Ctrl-C is not for it.
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::string name = program;
  std::array<char*, 3> words{name.data(), argument.data(), nullptr};
  const int error =
      ::posix_spawn(&process, program.c_str(), &actions, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

bool ends_within(std::chrono::milliseconds patience, pid_t process) {
  const UniqueFd handle(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
  pollfd look{handle.get(), POLLIN, 0};
  return handle.valid() && ::poll(&look, 1, static_cast<int>(patience.count())) > 0;
}

}  // namespace

Result<void> run_program(const std::string& program, std::string_view argument,
                         std::string_view input, std::chrono::milliseconds patience) {
  const UniqueFd file = file_of(input);
  if (!file.valid()) return failed(program, "no memory for its input");
  pid_t process = -1;
  const int error = spawn(process, program, std::string(argument), file.get());
  if (error != 0) return failed(program, std::strerror(error));  // NOLINT(concurrency-mt-unsafe)
  const bool ended = ends_within(patience, process);
  if (!ended) ::kill(-process, SIGKILL);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (!ended) return failed(program, fmt::format("killed after {} ms", patience.count()));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  return failed(program, WIFEXITED(status) ? fmt::format("status {}", WEXITSTATUS(status))
                                           : fmt::format("signal {}", WTERMSIG(status)));
}

}  // namespace slipstick
