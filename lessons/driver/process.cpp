// Starts programs by their path, or by a name that PATH leads to, without a shell.
#include "lessons/driver/process.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "lessons/driver/interruption.hpp"

namespace cairn::driver {
namespace {

List<char*> arguments_of(List<std::string>& words) {
  List<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return arguments;
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return 127;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// In the child, where no destructor of the parent may run.
[[noreturn]] void start(const List<char*>& arguments) {
  execvp(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

ProcessResult run_quietly(const List<std::string>& words) {
  List<std::string> copy = words;
  const List<char*> arguments = arguments_of(copy);
  int ends[2] = {-1, -1};
  if (pipe(ends) != 0) return {.code = 127, .output = std::strerror(errno)};
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    unsetenv("COLUMNS");  // its lines are read by programs: they stay whole
    close(ends[0]);
    close(ends[1]);
    start(arguments);
  }
  const ChildAtWork at_work(child);
  close(ends[1]);
  ProcessResult result;
  FixedList<char, 4096> buffer = {};
  for (ssize_t count = 0; (count = read(ends[0], buffer.data(), buffer.size())) != 0;) {
    if (count > 0) result.output.append(buffer.data(), buffer.data() + count);
    if (count < 0 && errno != EINTR) break;
  }
  close(ends[0]);
  result.code = child < 0 ? 127 : wait_for(child);
  return result;
}

int run_aloud(const List<std::string>& words) {
  List<std::string> copy = words;
  const List<char*> arguments = arguments_of(copy);
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) start(arguments);
  return child < 0 ? 127 : wait_for(child);
}

int become(const List<std::string>& words) {
  List<std::string> copy = words;
  const List<char*> arguments = arguments_of(copy);
  std::fflush(nullptr);
  execvp(arguments[0], arguments.data());
  std::fprintf(stderr, "lessons: cannot start %s: %s\n", words[0].c_str(), std::strerror(errno));
  return 3;
}

}  // namespace cairn::driver
