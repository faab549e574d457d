// Other programs, started.
#pragma once

#include <stdexcept>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn::driver {

struct ProcessResult {
  int code = 0;             // exit code; 128 + the signal that ended it
  std::string output = {};  // stdout and stderr as they came
};

/// A program has ended in a way that nothing can be made of; `code` is the exit code that follows from it.
struct ProgramFailed : std::runtime_error {
  ProgramFailed(const std::string& what, int exit_code) : std::runtime_error(what), code(exit_code) {}
  int code;
};

/// Runs a program to its end and keeps what it says. `words` begin with the path of the program or with its
/// name.
ProcessResult run_quietly(const List<std::string>& words);

/// Runs a program that speaks for itself. Returns its exit code.
int run_aloud(const List<std::string>& words);

/// Becomes the program, so that the keyboard and Ctrl-C are its own. Returns only when it cannot be started.
int become(const List<std::string>& words);

}  // namespace cairn::driver
