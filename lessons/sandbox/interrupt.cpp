// A flag and timers, which are all that a handler may touch.
#include "lessons/sandbox/interrupt.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "lessons/sandbox/verb.hpp"

namespace cairn::sandbox {
namespace {

volatile std::sig_atomic_t has_come = 0;
constexpr std::size_t longest_farewell = 4096;
char farewell[longest_farewell] = {};
std::size_t farewell_size = 0;

void end_here(int) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, farewell, farewell_size);
  _exit(stopped);
}

void note(int) {
  if (has_come != 0) return;  // who ends a group of processes often signals twice
  has_come = 1;
  const itimerval work = {.it_interval = {}, .it_value = {.tv_sec = 0, .tv_usec = 400'000}};
  const itimerval wait = {.it_interval = {}, .it_value = {.tv_sec = 4, .tv_usec = 0}};
  setitimer(ITIMER_PROF, &work, nullptr);
  setitimer(ITIMER_REAL, &wait, nullptr);
}

}  // namespace

void obey_interrupts() {
  say_when_stopped("stopped in the middle of its work");
  std::signal(SIGPROF, end_here);
  std::signal(SIGALRM, end_here);
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

void say_when_stopped(std::string_view words) {
  sigset_t ends = {}, before = {};
  sigemptyset(&ends);
  sigaddset(&ends, SIGPROF);
  sigaddset(&ends, SIGALRM);
  sigprocmask(SIG_BLOCK, &ends, &before);
  const std::string_view end_of_bar = is_terminal(stderr) ? "\n" : "";
  farewell_size = 0;
  for (const std::string_view part : {end_of_bar, std::string_view("cairn: "), words, std::string_view("\n")})
    farewell_size += part.copy(farewell + farewell_size, longest_farewell - farewell_size);
  sigprocmask(SIG_SETMASK, &before, nullptr);
}

bool interrupted() { return has_come != 0; }

}  // namespace cairn::sandbox
