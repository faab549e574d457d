// Ctrl-C while a book is made: the lesson at work is ended, and what was begun is cleaned up.
#pragma once

#include <sys/types.h>

#include <stdexcept>

namespace cairn::driver {

/// How the driver ends then, as shells say it of SIGINT and as `cairn` does.
inline constexpr int stopped = 130;

/// What was asked for was interrupted.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

/// From now on SIGINT and SIGTERM do not end this program but the one that it waits for: with SIGTERM, and
/// two seconds later with SIGKILL.
void note_interrupts();

/// @throws Interrupted where such a signal has come.
void require_uninterrupted();

/// The program that is waited for, while this lives.
class ChildAtWork {
 public:
  explicit ChildAtWork(pid_t child);
  ~ChildAtWork();
  ChildAtWork(const ChildAtWork&) = delete;
  ChildAtWork& operator=(const ChildAtWork&) = delete;
};

}  // namespace cairn::driver
