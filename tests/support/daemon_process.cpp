#include "tests/support/daemon_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <vector>

#include "core/base/check.h"
#include "drivers/unique_fd.h"

extern char** environ;

namespace slipstick::test {
namespace {

// The first line that comes.
std::string line_from(int fd) {
  std::string line;
  for (char c = 0; ::read(fd, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

}  // namespace

DaemonProcess::DaemonProcess(const std::filesystem::path& data, const std::string& printer) {
  std::vector<std::string> words{SLIPSTICK_BINARY, "serve",       "--data",    data.string(),
                                 "--listen",       "127.0.0.1:0", "--printer", printer};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int ends[2];
  SLIPSTICK_CHECK(::pipe2(ends, O_CLOEXEC) == 0);
  const UniqueFd from(ends[0]);
  UniqueFd to(ends[1]);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, to.get(), STDOUT_FILENO);
  SLIPSTICK_CHECK(::posix_spawn(&process_, argv[0], &actions, nullptr, argv.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
  to.reset();
  const std::string line = line_from(from.get());
  SLIPSTICK_CHECK(line.find("listening on http://127.0.0.1:") == 0);
  port_ = static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
}

DaemonProcess::~DaemonProcess() {
  if (process_ > 0) end(SIGKILL);
}

int DaemonProcess::end(int signal) {
  int status = 0;
  ::kill(process_, signal);
  SLIPSTICK_CHECK(::waitpid(process_, &status, 0) == process_);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace slipstick::test
