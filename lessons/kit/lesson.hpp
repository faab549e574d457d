// What every lesson shares: arguments, narration, claims that can fail, pictures and data on disk.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lessons/kit/card.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include "render/page.hpp"
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// One frame, drawn only if it is wanted.
struct Shot {
  std::string state = {};  // right of the header: "sweep 2/10 · row 2 of 3"
  std::string alt = {};    // what the picture shows, for those who cannot see it; never empty
  std::function<void(render::Page&)> draw = {};
  bool key = false;  // written with --frames key, of which there are at most 12
};

/// A lesson at work. Prints in the order: title, equations, scene, question, steps, results, checks, files.
class Lesson {
 public:
  ~Lesson();
  Lesson(const Lesson&) = delete;
  Lesson& operator=(const Lesson&) = delete;

  /// The value of a parameter of this lesson. Asking for one that LessonInfo does not list is a bug.
  double real(std::string_view flag) const;
  int whole(std::string_view flag) const;
  const std::string& choice(std::string_view flag) const;

  /// One line of narration; Greek and superscripts are spelt out with --plain, and -q drops it.
  void print(std::string_view line = {});
  /// A line that only -v shows.
  void detail(std::string_view line);
  /// One of many: a line if it is among the first, which are always shown, else a detail.
  void print_if(bool is_first, std::string_view line) { is_first ? print(line) : detail(line); }
  /// Asks the question of LessonInfo. Waits for a guess on a terminal, and with --predict, and tells idea and
  /// equations after it then. Silent where the reader has changed what the question is about.
  void predict();
  /// Compares the reader's guess or --answer with what the lesson has computed, and explains.
  void answer(const List<double>& right, double tolerance, std::string_view explanation);

  /// A claim: |value| must be at most `limit`. Prints "CHECK  claim .... value  ok"; a failure makes the
  /// program return 1. A value that is not a number fails.
  void check_small(std::string_view claim, double value, double limit);
  /// A claim: `value` must be within `tolerance` of `expected`.
  void check_equal(std::string_view claim, double value, double expected, double tolerance);
  /// A claim that holds or does not; `shown` is printed beside it.
  void check_that(std::string_view claim, bool holds, std::string_view shown);

  /// Whether film() will draw anything: without, skip what only pictures need.
  bool draws() const;
  /// Draws the frames that --frames asks for, writes them with frames.json, in --size and --theme.
  void film(const List<Shot>& shots);
  /// The lesson's numbers, tidy: rows.csv, --csv and --json.
  void data(const CsvTable& table);
  /// A fingerprint (FNV-1a, 64 bit) of the bits of the final state, printed at the end; --expect compares it.
  void fingerprint(const Snapshot& final_state);
  /// As above, for lessons without a world.
  void fingerprint(const List<double>& numbers);

 private:
  friend int run_lesson(const LessonInfo&, const std::function<void(Lesson&)>&, int, char**);
  struct State;
  explicit Lesson(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Thrown by a lesson whose simulation blew up where it should not have: exit code 4.
struct Diverged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown by a lesson that needs what this build does not have: exit code 77.
struct Skipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The whole of a lesson's main: reads the arguments, prints title and equations, runs, reports.
/// Returns 0 all claims held, 1 one did not, 2 usage, 3 cannot draw or write, 4 diverged, 77 skipped.
int run_lesson(const LessonInfo& info, const std::function<void(Lesson&)>& lesson, int argc, char** argv);

}  // namespace cairn
