// A flag and a timer, which are all that a handler may touch.
#include "lessons/sandbox/interrupt.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "lessons/sandbox/verb.hpp"

namespace cairn::sandbox {
namespace {

volatile std::sig_atomic_t has_come = 0;
std::string_view farewell = "cairn: stopped in the middle of its work\n";

void end_here(int) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, farewell.data(), farewell.size());
  _exit(stopped);
}

void note(int) {
  if (has_come != 0) return;  // who ends a group of processes often signals twice
  has_come = 1;
  const itimerval patience = {.it_interval = {}, .it_value = {.tv_sec = 0, .tv_usec = 400'000}};
  setitimer(ITIMER_REAL, &patience, nullptr);
}

}  // namespace

void obey_interrupts() {
  if (is_terminal(stderr)) farewell = "\ncairn: stopped in the middle of its work\n";  // there may be a bar
  std::signal(SIGALRM, end_here);
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

bool interrupted() { return has_come != 0; }

}  // namespace cairn::sandbox
