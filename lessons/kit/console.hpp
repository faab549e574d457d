// What people see while a lesson runs: narration, colours, plain ASCII, a progress bar.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace cairn {

enum class When { automatic, always, never };

struct ConsoleSettings {
  When color = When::automatic;     // automatic: on a terminal, unless NO_COLOR is set or TERM is dumb
  When progress = When::automatic;  // automatic: if stderr is a terminal
  bool plain = false;               // ASCII without colour
  bool quiet = false;               // results only
  bool verbose = false;
  bool narrates_on_stderr = false;  // because stdout is data
};

/// Whether colours are wanted on this stream.
bool colors_wanted(const ConsoleSettings& settings, bool is_terminal);

bool is_terminal(std::FILE* stream);

/// The columns that lines on this stream have to fit: COLUMNS if that is set, else those of the terminal.
/// Lines in a file or a pipe are as long as they were written.
int width_of_stream(std::FILE* stream);

class Console {
 public:
  enum class Color { none, bold, good, bad, faint };

  explicit Console(const ConsoleSettings& settings);
  ~Console() { flush(); }
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  Console(Console&&) = default;

  const ConsoleSettings& settings() const { return settings_; }
  /// The width that lines have to fit.
  int width() const { return width_; }
  /// Narration: one line, dropped when quiet. A line of a table waits for the others: see fitted().
  void narrate(std::string_view line, Color color = Color::none);
  /// A result: one line, never dropped.
  void result(std::string_view line);
  /// Writes what waits.
  void flush();
  /// The text as it is to be put into a line: coloured if colours are wanted.
  std::string colored(std::string_view text, Color color) const;
  /// The text as --plain wants it, and without what could command the terminal: see printable().
  std::string spelt(std::string_view text) const;
  /// A question to the reader: no line end, and shown immediately.
  void ask(std::string_view question);
  /// A warning or an error: one line on stderr.
  void warn(std::string_view line);
  /// Waits for Enter. False at the end of the input.
  bool wait();

 private:
  void write(std::string_view line, Color color);

  ConsoleSettings settings_;
  std::FILE* stream_;
  bool has_colors_ = false;
  int width_;
  std::string table_ = {};  // lines that wait
};

/// A bar on stderr, from one second after it was made: quick runs show none.
class Progress {
 public:
  Progress(const ConsoleSettings& settings, std::string what, int total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `rest`: what is written behind the bar beside the count, such as the time that is left.
  void advance(int done, std::string_view rest = "");
  /// From now on there are so many in all.
  void expect(int total) { total_ = total; }
  /// Wipes the bar from the line.
  void clear();

 private:
  std::string what_;
  int total_;
  bool wanted_ = false;
  bool always_ = false;
  int shown_width_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace cairn
