// Starts a program under limits, and ends it with its descendants.
#include "lessons/reader_code/family.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

#include "lessons/reader_code/verdict.hpp"

namespace cairn::reader_code {
namespace {

struct Pipe {
  int reading = -1;
  int writing = -1;
};

bool open_pipe(Pipe& ends) {
  int both[2] = {-1, -1};
  if (pipe2(both, O_CLOEXEC) != 0) return false;
  ends = {both[0], both[1]};
  return fcntl(ends.reading, F_SETFL, O_NONBLOCK) == 0;
}

void close_pipe(const Pipe& ends) {
  if (ends.reading >= 0) close(ends.reading);
  if (ends.writing >= 0) close(ends.writing);
}

std::string drawn_word() {
  std::random_device draw;
  std::string word;
  for (int i = 0; i < 16; ++i) word += "0123456789abcdef"[draw() % 16];
  return word;
}

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
  rlimit now = {};
  getrlimit(what, &now);
  now.rlim_max = std::min(now.rlim_max, most);
  now.rlim_cur = std::min(now.rlim_cur, now.rlim_max);
  setrlimit(what, &now);
}

void apply(const Limits& limits) {
  constexpr rlim_t stack = 8 << 20;
  // The clock is what ends it; the time of its processor is for when nobody looks at the clock any more.
  limit(RLIMIT_CPU, static_cast<rlim_t>(8 * limits.seconds) + 1);
  limit(RLIMIT_FSIZE, limits.file);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_STACK, stack);  // never endless: an end that is known can be told from other accesses
  if (!detail::says_more_by_itself) limit(RLIMIT_AS, limits.memory);
}

/// In the new process, where no destructor of the old one may run.
[[noreturn]] void become(const Job& job, const List<char*>& arguments, const std::string& variable,
                         pid_t parent, const Pipe& out, const Pipe& error, const Pipe& verdict) {
  setsid();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(signal, SIG_DFL);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(out.writing, STDOUT_FILENO);
  dup2(error.writing, STDERR_FILENO);
  if (nothing > STDERR_FILENO) close(nothing);
  if (!job.is_compiler) {
    fcntl(verdict.writing, F_SETFD, 0);
    setenv(verdict_variable, variable.c_str(), 1);
  }
  apply(job.limits);
  execvp(arguments[0], arguments.data());
  dprintf(verdict.writing, "%s no_start %d\n", variable.substr(variable.find(' ') + 1).c_str(), errno);
  _exit(127);
}

/// The parent of a process, or 0.
pid_t parent_of(const char* process) {
  std::ifstream file(std::string("/proc/") + process + "/stat");
  std::string text;
  std::getline(file, text, '\0');
  const std::size_t name_end = text.rfind(')');  // a name may have brackets in it
  int parent = 0;
  if (name_end != std::string::npos) std::sscanf(text.c_str() + name_end, ") %*c %d", &parent);
  return parent;
}

List<pid_t> own_children() {
  List<pid_t> children;
  DIR* const all = opendir("/proc");
  if (all == nullptr) return children;
  const pid_t self = getpid();
  while (const dirent* const entry = readdir(all)) {
    const bool is_process = entry->d_name[0] >= '1' && entry->d_name[0] <= '9';
    if (is_process && parent_of(entry->d_name) == self) children.push_back(std::atoi(entry->d_name));
  }
  closedir(all);
  return children;
}

}  // namespace

Started start(const Job& job) {
  Pipe out, error, verdict;
  Started started = {.word = drawn_word()};
  List<std::string> words = job.command;
  List<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // whoever loses its parent down there becomes a child of this process
  if (open_pipe(out) && open_pipe(error) && open_pipe(verdict)) {
    const std::string variable = std::to_string(verdict.writing) + " " + started.word;
    const pid_t parent = getpid();
    std::fflush(nullptr);
    started.process = fork();
    if (started.process == 0) become(job, arguments, variable, parent, out, error, verdict);
  }
  const int why = errno;
  if (started.process > 0) {
    started.out = out.reading, started.error = error.reading, started.verdict = verdict.reading;
    out.reading = error.reading = verdict.reading = -1;
  }
  for (const Pipe& ends : {out, error, verdict}) close_pipe(ends);
  errno = why;
  return started;
}

int end_family(pid_t process) {
  int status = 0;
  kill(-process, SIGKILL);  // all of its group at one time
  kill(process, SIGKILL);
  waitpid(process, &status, 0);
  // Those that had left the group have no other parent now, or will have none when theirs has ended.
  constexpr int tries = 2000, between = 1000;  // microseconds
  for (int i = 0; i < tries; ++i) {
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    const List<pid_t> children = own_children();
    if (children.empty()) break;
    for (const pid_t child : children) kill(child, SIGKILL);
    usleep(between);
  }
  prctl(PR_SET_CHILD_SUBREAPER, 0);
  return status;
}

bool has_ended(pid_t process) {
  siginfo_t info = {};
  return waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == process;
}

}  // namespace cairn::reader_code
