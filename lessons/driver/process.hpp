// Other programs, started.
#pragma once

#include <string>

#include "math/list.hpp"

namespace cairn::driver {

struct ProcessResult {
  int code = 0;             // exit code; 128 + the signal that ended it
  std::string output = {};  // stdout and stderr as they came
};

/// Runs a program to its end and keeps what it says. `words` begin with the path of the program.
ProcessResult run_quietly(const List<std::string>& words);

/// Runs a program that speaks for itself. Returns its exit code.
int run_aloud(const List<std::string>& words);

/// Becomes the program, so that the keyboard and Ctrl-C are its own. Returns only when it cannot be started.
int become(const List<std::string>& words);

}  // namespace cairn::driver
