// How far a long piece of work has come: a bar on a terminal, a plain line now and then in a pipe.
#pragma once

#include <chrono>
#include <string>

#include "lessons/kit/console.hpp"

namespace cairn::sandbox {

/// "12 s left", "3 min left".
std::string time_left_text(double seconds);

/// On stderr, from one second on; nothing when quiet.
class ProgressLine {
 public:
  ProgressLine(const ConsoleSettings& settings, std::string what, int total);

  void advance(int done);
  /// The same where somebody knows better how long the rest will take.
  void advance(int done, double seconds_left);
  void clear() { bar_.clear(); }

 private:
  std::string what_;
  int total_;
  bool is_plain_;
  Progress bar_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_line_;
};

}  // namespace cairn::sandbox
