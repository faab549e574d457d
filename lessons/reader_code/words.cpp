// Judges how a program ended, and says it.
#include "lessons/reader_code/words.hpp"

#include <signal.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

namespace cairn::reader_code {
namespace {

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::string number(double value) {
  char digits[32] = "";
  std::snprintf(digits, sizeof digits, "%g", value);
  return digits;
}

std::string time_words(const Job& job) {
  const std::string seconds = number(job.limits.seconds) + " s";
  if (job.is_compiler)
    return "Compiling " + job.file + " took longer than " + seconds +
           " and was stopped: does a template or a constexpr function go on without end?";
  return job.file + " did not end within " + seconds + ": does one of its loops never stop?";
}

std::string output_words(const Job& job) {
  const std::string size = number(static_cast<double>(job.limits.output) / 1e6) + " MB";
  if (job.is_compiler)
    return "Compiling " + job.file + " was stopped: it brought more than " + size + " of messages.";
  return job.file + " was stopped: it printed more than " + size +
         ". Does one of its loops print without end?";
}

/// What a signal usually means, as what the file has done.
std::string signal_words(int signal, const Ending& ending) {
  if (signal == SIGSEGV && has(ending.verdict, "stack"))
    return "ran out of stack: a function that calls itself without end, or a very large array in a function";
  if (signal == SIGSEGV && has(ending.verdict, "null"))
    return "used a pointer that leads nowhere, a null pointer";
  if (signal == SIGABRT && has(ending.standard, "__n < ")) return "used an index outside of a list";
  if (signal == SIGABRT && has(ending.standard, "empty()")) return "took an element from an empty list";
  if (signal == SIGABRT && !ending.standard.empty())
    return "broke a rule of the standard library, " + ending.standard;
  const std::map<int, const char*> meanings = {
      {SIGSEGV, "read or wrote where it has nothing (a null pointer, or past the end of a list)"},
      {SIGBUS, "read or wrote where it has nothing (past the end of a list, or of a file)"},
      {SIGABRT, "called abort(), or something did for it: an assert() that fails, std::terminate()"},
      {SIGFPE, "divided a whole number by 0"},
      {SIGILL, "came to a place that has no code: a function that ends without its return?"},
      {SIGTRAP, "came to a place that has no code: a function that ends without its return?"},
      {SIGXFSZ, "wrote a file that is too long"},
      {SIGKILL, "was killed from outside, as happens where the computer has no memory left"}};
  const auto meaning = meanings.find(signal);
  return meaning == meanings.end() ? "was ended by a signal" : meaning->second;
}

/// The verdict, or -1.
int verdict_of(const Ending& ending) {
  const std::string mark = "ended ";
  const std::size_t at = ending.verdict.find(mark);
  return at == std::string::npos ? -1 : std::atoi(ending.verdict.c_str() + at + mark.size());
}

Ended judged_grader(const Job& job, const Ending& ending) {
  const int verdict = verdict_of(ending), code = WEXITSTATUS(ending.status);
  if (verdict == code) return {.code = code};
  const std::string with = " (exit code " + std::to_string(code) + ")";
  if (verdict >= 0)
    return {1, job.file + " ended the program in a way of its own after the grader was done" + with + "."};
  return {1, job.file + " ended the program before the grader was done" + with +
                 ": is there an exit(), quick_exit() or _exit() in it?"};
}

}  // namespace

bool is_of_the_standard_library(const std::string& line) {
  return has(line, "/bits/") && has(line, "Assertion '") && has(line, "' failed.");
}

Ended judged(const Job& job, const Ending& ending) {
  const std::string refusal = "no_start ";
  const std::size_t refused = ending.verdict.find(refusal);
  if (refused != std::string::npos)
    return {3, "cannot start " + job.command.front() + ": " +
                   std::strerror(std::atoi(ending.verdict.c_str() + refused + refusal.size()))};
  const int limited = job.is_compiler ? limit_reached : 1;
  const int signal = WIFSIGNALED(ending.status) ? WTERMSIG(ending.status) : 0;
  if (ending.stop == Stop::unwritable) return {.code = 3};
  if (ending.stop == Stop::output) return {limited, output_words(job)};
  if (ending.stop == Stop::time || signal == SIGXCPU) return {limited, time_words(job)};
  if (signal == 0)
    return job.is_compiler ? Ended{.code = WEXITSTATUS(ending.status)} : judged_grader(job, ending);
  if (job.is_compiler)
    return {128 + signal,
            "The compiler of " + job.file + " was ended: signal " + std::to_string(signal) + "."};
  return {1, job.file + " " + signal_words(signal, ending) + ": signal " + std::to_string(signal) + "."};
}

}  // namespace cairn::reader_code
