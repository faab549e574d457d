// Why a program ended before it was done, in words.
#pragma once

#include <string>

#include "lessons/reader_code/run.hpp"

namespace cairn::reader_code {

/// What ended a program from outside.
enum class Stop { none, time, output, unwritable };

/// What is known of a program that has ended.
struct Ending {
  int status = 0;             // as waitpid() has it
  Stop stop = Stop::none;     // the status does not matter where there is one
  std::string verdict = {};   // the lines of verdict.hpp, without what opens them
  std::string standard = {};  // the line that the standard library wrote when it stopped the program
};

/// Whether this line of stderr is of a check in the standard library, whose words say little to a reader.
bool is_of_the_standard_library(const std::string& line);

/// The code and the words of what has ended.
Ended judged(const Job& job, const Ending& ending);

}  // namespace cairn::reader_code
