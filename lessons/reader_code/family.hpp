// A program that is started under limits, and the end of it and of everything that it has started.
#pragma once

#include <sys/types.h>

#include <string>

#include "lessons/reader_code/run.hpp"

namespace cairn::reader_code {

/// A program that runs. The ends of its pipes are here, and reading them never waits.
struct Started {
  pid_t process = -1;     // and its session; -1: none, and errno says why
  int out = -1;           // its stdout
  int error = -1;         // its stderr
  int verdict = -1;       // what it tells by verdict.hpp, or by tell_no_start
  std::string word = {};  // that opens every line of the verdict
};

/// Starts the program of a job under its limits, in a session of its own, with nothing to read.
Started start(const Job& job);

/// Kills the program and all that it has started, waits for their ends, and returns the status of the program
/// as waitpid() has it.
int end_family(pid_t process);

/// Whether the program has ended; its status stays to be waited for.
bool has_ended(pid_t process);

}  // namespace cairn::reader_code
