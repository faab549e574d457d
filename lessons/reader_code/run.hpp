// Runs the code of a reader, which may do anything by mistake: never end, print without end, crash, leave
// processes behind, or end the program early. Both graders use it, and the compilers of what is graded. It
// needs the standard library and Linux only, because the grader of the reader's own solver compiles it by
// itself.
#pragma once

#include <cstddef>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn::reader_code {

/// What a program may use up.
struct Limits {
  double seconds = 10;             // from its start to its end
  std::size_t output = 1'000'000;  // bytes that it prints, on both streams together
  std::size_t memory =
      1'000'000'000;  // bytes of addresses; not looked at under sanitizers, which take all of them
  std::size_t file = 50'000'000;  // bytes of any file that it writes
};

/// The limits of a compiler.
inline constexpr Limits compiler_limits = {
    .seconds = 120, .output = 4'000'000, .memory = 4'000'000'000, .file = 500'000'000};

struct Job {
  List<std::string> command = {};  // a program, by its path or a name of the PATH, and its arguments
  std::string file = {};           // what the reader has written, as words call it
  Limits limits = {};
  bool is_compiler = false;  // its exit code counts; that of a grader does only if it is also its verdict
};

/// The code of a compiler that came to a limit.
inline constexpr int limit_reached = 124;

struct Ended {
  /// Of a grader its verdict (verdict.hpp), or 1 where it has given none. Of a compiler its exit code, 128 +
  /// the signal that ended it, or limit_reached. 3 if the program cannot be started, or stdout does not take
  /// what it prints.
  int code = 0;
  std::string words = {};  // a line or none: why it ended before it was done
};

/// Runs a program to its end, with nothing to read, and prints what it prints. When this returns, neither the
/// program lives nor any process that it has started, under whatever group or session. (One that starts
/// copies of itself faster than they can be ended is given up on after some seconds.) SIGINT, SIGTERM, SIGHUP
/// and SIGQUIT end the program and its processes first, and then this process.
Ended run(const Job& job);

}  // namespace cairn::reader_code
