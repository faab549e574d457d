// The program run_reader, for those that are no C++: the script of the reader's own solver, and ninja.
#include <signal.h>
#include <sys/prctl.h>

#include <cstdio>
#include <string_view>

#include "lessons/kit/output.hpp"
#include "lessons/reader_code/run.hpp"

int main(int count, char** words) {
  using namespace cairn;
  const std::string_view what = count > 1 ? words[1] : "";
  if (count < 4 || (what != "grader" && what != "compiler")) {
    std::fprintf(
        stderr,
        "run_reader: the words must be grader|compiler, what the reader's file is called, and a command\n");
    return 2;
  }
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // nobody waits for the outcome any more
  const bool is_compiler = what == "compiler";
  const reader_code::Ended ended =
      reader_code::run({.command = {words + 3, words + count},
                        .file = words[2],
                        .limits = is_compiler ? reader_code::compiler_limits : reader_code::Limits{},
                        .is_compiler = is_compiler});
  if (!ended.words.empty()) {
    std::fprintf(is_compiler || ended.code == 3 ? stderr : stdout, "%s\n", ended.words.c_str());
  }
  if (output_is_written()) return ended.code;
  std::fprintf(stderr, "run_reader: the output cannot be written\n");
  return 3;
}
