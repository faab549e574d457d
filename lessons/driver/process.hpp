// Other programs, started.
#pragma once

#include <string>
#include <vector>

namespace cairn::driver {

struct ProcessResult {
  int code = 0;             // exit code; 128 + the signal that ended it
  std::string output = {};  // stdout and stderr as they came
};

/// Runs a program to its end and keeps what it says. `words` begin with the path of the program.
ProcessResult run_quietly(const std::vector<std::string>& words);

/// Runs a program that speaks for itself. Returns its exit code.
int run_aloud(const std::vector<std::string>& words);

/// Becomes the program, so that the keyboard and Ctrl-C are its own. Returns only when it cannot be started.
int become(const std::vector<std::string>& words);

}  // namespace cairn::driver
