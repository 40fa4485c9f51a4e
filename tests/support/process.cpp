#include "tests/support/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "core/base/check.h"
#include "tests/support/temporary_folder.h"

extern char** environ;

namespace slipstick::test {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

Finished run(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out", err = folder.path() / "err";
  std::vector<std::string> words{"timeout", "300"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), flags, 0600);
  pid_t child = 0;
  SLIPSTICK_CHECK(::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  SLIPSTICK_CHECK(::waitpid(child, &status, 0) == child);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, content(out), content(err)};
}

Finished slipstick(std::vector<std::string> arguments) {
  const std::string_view leaks_of_others =
      "LSAN_OPTIONS=print_suppressions=0:suppressions=" SLIPSTICK_SOURCE_DIR
      "/tests/support/lsan.txt";
  arguments.insert(arguments.begin(),
                   {"/usr/bin/env", std::string(leaks_of_others), SLIPSTICK_BINARY});
  return run(arguments);
}

}  // namespace slipstick::test
