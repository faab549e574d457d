// Bars and lines of progress.
#include "lessons/sandbox/progress_line.hpp"

#include <fmt/format.h>

namespace cairn::sandbox {
namespace {

constexpr std::chrono::seconds between_lines(10);

ConsoleSettings bar_settings(ConsoleSettings settings) {
  if (settings.quiet && settings.progress == When::automatic) settings.progress = When::never;
  return settings;
}

}  // namespace

std::string time_left_text(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s left", seconds) : fmt::format("{:.0f} min left", seconds / 60);
}

ProgressLine::ProgressLine(const ConsoleSettings& settings, std::string what, int total)
    : what_(what),
      total_(total),
      is_plain_(settings.progress == When::automatic && !settings.quiet && !is_terminal(stderr)),
      bar_(bar_settings(settings), std::move(what), total),
      start_(std::chrono::steady_clock::now()),
      last_line_(start_) {}

void ProgressLine::advance(int done) {
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  advance(done, done > 0 ? elapsed * static_cast<double>(total_ - done) / static_cast<double>(done) : 0);
}

void ProgressLine::advance(int done, double seconds_left) {
  const auto now = std::chrono::steady_clock::now();
  bar_.advance(done, time_left_text(seconds_left));
  if (!is_plain_ || now - last_line_ < between_lines) return;
  last_line_ = now;
  fmt::print(stderr, "{} of {} {}, {}\n", done, total_, what_, time_left_text(seconds_left));
}

}  // namespace cairn::sandbox
