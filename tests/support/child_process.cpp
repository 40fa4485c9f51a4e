#include "tests/support/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <utility>

#include "core/base/check.h"

extern char** environ;

namespace slipstick::test {

ChildProcess::ChildProcess(std::vector<std::string> arguments)
    : ChildProcess(SLIPSTICK_BINARY, std::move(arguments)) {}

ChildProcess::ChildProcess(const std::string& program, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (std::string& word : arguments) argv.push_back(word.data());
  argv.push_back(nullptr);
  int ends[2];
  SLIPSTICK_CHECK(::pipe2(ends, O_CLOEXEC) == 0);
  out_ = UniqueFd(ends[0]);
  const UniqueFd to(ends[1]);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, to.get(), STDOUT_FILENO);
  SLIPSTICK_CHECK(::posix_spawnp(&process_, argv[0], &actions, nullptr, argv.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
}

ChildProcess::~ChildProcess() {
  if (process_ < 0) return;
  send(SIGKILL);
  wait();
}

std::string ChildProcess::line() {
  std::string line;
  for (char c = 0; ::read(out_.get(), &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

void ChildProcess::send(int signal) const {
  SLIPSTICK_CHECK(process_ > 0);  // or everything would get it
  ::kill(process_, signal);
}

int ChildProcess::wait() {
  int status = 0;
  SLIPSTICK_CHECK(::waitpid(process_, &status, 0) == process_);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace slipstick::test
