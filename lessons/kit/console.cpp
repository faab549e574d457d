// Terminals: who has one, and what it can do.
#include "lessons/kit/console.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "lessons/kit/fitting.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/math/printable.hpp>

namespace cairn {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

int width_of_stream(std::FILE* stream) {
  constexpr double least = 40;
  const std::optional<double> columns = parse_number(environment("COLUMNS"));
  if (columns && *columns >= 1) return static_cast<int>(std::clamp(*columns, least, 1e4));
  if (!is_terminal(stream)) return unlimited;
  winsize size = {};
  if (ioctl(fileno(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return std::max(static_cast<int>(least), int{size.ws_col});
}

bool colors_wanted(const ConsoleSettings& settings, bool is_terminal) {
  if (settings.plain || settings.color == When::never) return false;
  if (settings.color == When::always) return true;
  return is_terminal && environment("NO_COLOR").empty() && environment("TERM") != "dumb";
}

Console::Console(const ConsoleSettings& settings)
    : settings_(settings), stream_(settings.narrates_on_stderr ? stderr : stdout) {
  has_colors_ = colors_wanted(settings_, is_terminal(stream_));
  width_ = width_of_stream(stream_);
}

void Console::write(std::string_view line, Color color) {
  const bool is_set = width_ < unlimited || settings_.plain;
  const bool is_of_table = has_cells(line) || (!table_.empty() && line.starts_with("  "));
  if (is_set && color == Color::none && is_of_table && line.find('\n') == std::string_view::npos) {
    table_ += std::string(line) + "\n";
    return;
  }
  flush();
  std::string text = is_set ? fitted(line, width_, settings_.plain) : std::string(line);
  if (text.ends_with('\n')) text.pop_back();
  text = colored(text, color) + "\n";
  std::fwrite(text.data(), 1, text.size(), stream_);
}

void Console::flush() {
  const std::string text = fitted(std::exchange(table_, ""), width_, settings_.plain);
  std::fwrite(text.data(), 1, text.size(), stream_);
}

void Console::narrate(std::string_view line, Color color) {
  if (!settings_.quiet) write(printable(line), color);
}

void Console::result(std::string_view line) { write(line, Color::none); }

std::string Console::colored(std::string_view text, Color color) const {
  const char* code = color == Color::bold   ? "1"
                     : color == Color::good ? "32"
                     : color == Color::bad  ? "1;31"
                                            : "2";
  if (!has_colors_ || color == Color::none || text.empty()) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

std::string Console::spelt(std::string_view text) const {
  const std::string shown = printable(text);
  return settings_.plain ? transliterated(shown) : shown;
}

void Console::ask(std::string_view question) {
  flush();
  const std::string text = spelt(question);
  std::fwrite(text.data(), 1, text.size(), stream_);
  std::fflush(stream_);
}

void Console::warn(std::string_view line) {
  flush();
  std::fflush(stdout);  // in the order of events, where both go to one terminal
  const std::string text = fitted(spelt(line) + "\n", width_of_stream(stderr));
  std::fwrite(text.data(), 1, text.size(), stderr);
}

bool Console::wait() {
  flush();
  std::fflush(stream_);
  std::string line;
  return static_cast<bool>(std::getline(std::cin, line));
}

Progress::Progress(const ConsoleSettings& settings, std::string what, int total)
    : what_(std::move(what)), total_(total), start_(std::chrono::steady_clock::now()) {
  always_ = settings.progress == When::always;
  wanted_ = always_ || (settings.progress == When::automatic && is_terminal(stderr));
}

Progress::~Progress() { clear(); }

void Progress::advance(int done, std::string_view rest) {
  if (!wanted_) return;
  if (!always_ && std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  constexpr int width = 30;
  const auto share = total_ == 0 ? 1LL * width : std::min(1LL * width, 1LL * width * done / total_);
  const auto filled = static_cast<int>(share);
  const std::string bar = repeated('#', filled) + repeated('.', width - filled);
  const std::string text =
      fmt::format("[{}] {}/{} {}{}{}", bar, done, total_, what_, rest.empty() ? "" : ", ", rest);
  std::fflush(stdout);
  fmt::print(stderr, "\r{:<{}}", text, shown_width_);
  std::fflush(stderr);
  shown_width_ = std::max(shown_width_, static_cast<int>(text.size()));
}

void Progress::clear() {
  if (shown_width_ == 0) return;
  // Blanks, not an escape code: they work on every terminal.
  fmt::print(stderr, "\r{}\r", repeated(' ', shown_width_));
  std::fflush(stderr);
  shown_width_ = 0;
}

}  // namespace cairn
