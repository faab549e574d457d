// Runs a program under its limits, and prints what it prints.
#include "lessons/reader_code/run.hpp"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string_view>

#include "lessons/reader_code/family.hpp"
#include "lessons/reader_code/words.hpp"

namespace cairn::reader_code {
namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t told_to_stop = 0;

constexpr std::array<int, 4> stopping_signals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/// While this lives, signals that would end this process are only noted, and output that nobody takes is an
/// error.
class SignalsHeld {
 public:
  SignalsHeld() {
    told_to_stop = 0;
    struct sigaction noting = {};
    noting.sa_handler = [](int signal) { told_to_stop = signal; };
    for (std::size_t i = 0; i < stopping_signals.size(); ++i) {
      sigaction(stopping_signals[i], nullptr, &before_[i]);
      if (before_[i].sa_handler != SIG_IGN) sigaction(stopping_signals[i], &noting, nullptr);
    }
    struct sigaction nothing = {};
    nothing.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &nothing, &pipe_before_);
    signal(SIGCHLD, SIG_DFL);  // a parent that ignores it hands that on, and then no child can be waited for
  }
  ~SignalsHeld() {
    for (std::size_t i = 0; i < stopping_signals.size(); ++i)
      sigaction(stopping_signals[i], &before_[i], nullptr);
    sigaction(SIGPIPE, &pipe_before_, nullptr);
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  std::array<struct sigaction, stopping_signals.size()> before_ = {};
  struct sigaction pipe_before_ = {};
};

/// Reads what is there, and hands it on. False at the end.
template <typename Take>
bool drain(int place, const Take& take) {
  std::array<char, 65536> buffer = {};
  while (true) {
    const ssize_t count = read(place, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN;
    if (count == 0) return false;
    if (!take(std::string_view(buffer.data(), static_cast<std::size_t>(count)))) return true;
  }
}

/// Follows a program from its start to its end.
class Watch {
 public:
  Watch(const Job& job, const Started& program) : job_(job), program_(program) {}
  ~Watch() {
    for (const int place : {program_.out, program_.error, program_.verdict}) close(place);
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  Ended follow() {
    const auto end = Clock::now() + std::chrono::duration<double>(job_.limits.seconds);
    std::array<pollfd, 2> places = {pollfd{program_.out, POLLIN, 0}, pollfd{program_.error, POLLIN, 0}};
    while (told_to_stop == 0 && ending_.stop == Stop::none && !has_ended(program_.process)) {
      constexpr int milliseconds = 20;
      poll(places.data(), places.size(), milliseconds);
      if (!hand_on_output()) places[0].fd = -1;
      if (!hand_on_errors()) places[1].fd = -1;
      if (Clock::now() > end && ending_.stop == Stop::none) ending_.stop = Stop::time;
    }
    ending_.status = end_family(program_.process);
    hand_on_output();
    hand_on_errors();
    hand_on_line();
    for (std::FILE* const stream : {stdout, stderr})
      if (has_open_line(stream)) std::fputc('\n', stream);  // the words begin a line of their own
    drain(program_.verdict, [this](std::string_view text) { return note(text); });
    return judged(job_, ending_);
  }

 private:
  bool hand_on_output() {
    return drain(program_.out, [this](std::string_view text) { return print(text, stdout); });
  }

  /// Line by line: some are kept back.
  bool hand_on_errors() {
    return drain(program_.error, [this](std::string_view text) {
      constexpr std::size_t longest = 4096;
      for (const char c : text) {
        line_ += c;
        if (c == '\n' || line_.size() == longest) hand_on_line();
      }
      return ending_.stop == Stop::none;
    });
  }

  void hand_on_line() {
    if (!job_.is_compiler && is_of_the_standard_library(line_))
      ending_.standard = line_.substr(0, line_.find_last_not_of('\n') + 1);
    else
      print(line_, stderr);
    line_.clear();
  }

  bool& has_open_line(std::FILE* stream) { return open_lines_[stream == stdout ? 0 : 1]; }

  /// Whether there may be more.
  bool print(std::string_view text, std::FILE* stream) {
    if (ending_.stop == Stop::output || ending_.stop == Stop::unwritable) return false;
    const std::size_t room = job_.limits.output - printed_, count = std::min(room, text.size());
    printed_ += count;
    if (count > 0) has_open_line(stream) = text[count - 1] != '\n';
    const bool is_written = std::fwrite(text.data(), 1, count, stream) == count && std::fflush(stream) == 0;
    if (!is_written && stream == stdout) ending_.stop = Stop::unwritable;
    if (count < text.size()) ending_.stop = Stop::output;
    return ending_.stop == Stop::none;
  }

  /// Keeps the lines of the verdict that are from the program itself.
  bool note(std::string_view text) {
    constexpr std::size_t longest = 4096;
    const std::string opening = program_.word + " ";
    const std::string from_it = opening + std::to_string(program_.process) + " ";
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(from_it)) ending_.verdict += line.substr(from_it.size()) + "\n";
      if (line.starts_with(opening + "no_start ")) ending_.verdict += line.substr(opening.size()) + "\n";
    }
    return ending_.verdict.size() < longest;
  }

  const Job& job_;
  Started program_;
  Ending ending_;
  std::size_t printed_ = 0;
  std::array<bool, 2> open_lines_ = {};
  std::string line_;  // of stderr, so far
};

}  // namespace

Ended run(const Job& job) {
  Ended ended;
  {
    const SignalsHeld held;
    const Started program = start(job);
    if (program.process < 0) return {3, "cannot start " + job.command.front() + ": " + std::strerror(errno)};
    ended = Watch(job, program).follow();
  }
  if (told_to_stop != 0) raise(told_to_stop);  // as if it had not been held
  return ended;
}

}  // namespace cairn::reader_code
