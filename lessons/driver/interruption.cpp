// Two numbers and a timer, which are all that a handler may touch.
#include "lessons/driver/interruption.hpp"

#include <sys/time.h>

#include <csignal>

namespace cairn::driver {
namespace {

volatile std::sig_atomic_t signal_has_come = 0;
volatile std::sig_atomic_t child_at_work = 0;  // 0: none

void end_child(int signal) {
  const pid_t child = child_at_work;
  if (child > 0) kill(child, signal);
}

void end_child_now(int) { end_child(SIGKILL); }

void note_signal(int) {
  if (signal_has_come != 0) return;  // who ends a group of processes often signals twice
  signal_has_come = 1;
  const itimerval patience = {.it_interval = {}, .it_value = {.tv_sec = 2, .tv_usec = 0}};
  setitimer(ITIMER_REAL, &patience, nullptr);
  end_child(SIGTERM);
}

}  // namespace

void note_interrupts() {
  std::signal(SIGALRM, end_child_now);
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

void require_uninterrupted() {
  if (signal_has_come != 0) throw Interrupted();
}

ChildAtWork::ChildAtWork(pid_t child) {
  child_at_work = child;
  if (signal_has_come != 0) end_child(SIGTERM);  // it came before there was a child to end
}

ChildAtWork::~ChildAtWork() { child_at_work = 0; }

}  // namespace cairn::driver
