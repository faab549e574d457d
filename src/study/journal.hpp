// Floor 9. Long studies, task by task on disk: they can be stopped, taken up again, and shared out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <cairn/measure/csv.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Which share of the tasks one of several processes does: the `number`-th of `of`, from 1.
struct Shard {
  int number = 1;
  int of = 1;
  bool holds(int task) const { return task % of == number - 1; }
};

/// From "2/8". @throws std::invalid_argument unless it is k/n with 1 <= k <= n <= 10000.
Shard parse_shard(std::string_view text);

/// One thing to find out, whose answer is one row of the table.
struct StudyTask {
  std::string name = {};
  std::function<List<CsvCell>()> run = {};
};

struct Study {
  std::string name = {};  // one line that tells this study from every other: what a journal belongs to
  List<std::string> header = {};  // of a row; the number of the task is written before it
  List<StudyTask> tasks = {};
};

/// The answers found so far: a file with the study's name, the build's, a header, a line for each task in
/// the order in which they were done, and a last line once all are. A line that was cut off is forgotten. The
/// file is only ever replaced as a whole or appended to.
class Journal {
 public:
  /// Takes up what is there; begins the file where there is none, or one of another study or build that has
  /// all of its answers.
  /// @throws std::invalid_argument when the file is of another study or build that may go on, or cannot be
  /// understood, std::runtime_error when it cannot be written; both name the file.
  Journal(std::filesystem::path path, const Study& study);

  bool has(int task) const { return lines_.count(task) != 0; }
  /// Is on disk when it returns. @throws std::runtime_error.
  void write(int task, const List<CsvCell>& row);
  int size() const { return static_cast<int>(lines_.size()); }
  /// Takes over what another journal of the study has. @throws as the constructor.
  void absorb(const std::filesystem::path& other);
  /// All rows in the order of the tasks: the same bytes for the same answers, however they were shared out.
  std::string csv() const;

 private:
  std::string head() const;
  bool is_of_another_that_is_done(const std::filesystem::path& path) const;
  void read(const std::filesystem::path& path);
  void rewrite() const;

  std::filesystem::path path_;
  std::string study_;
  std::string header_;
  int tasks_ = 0;
  std::map<int, std::string> lines_;  // by task, without the line break
};

/// How many tasks the shard has.
int tasks_in(const Study& study, const Shard& shard);

/// Told after every task: how many of `total` are done, and how many seconds those that are left will take if
/// they are like those of this run. False stops the study.
using StudyProgress = std::function<bool(int done, int total, double seconds_left)>;

/// Does the tasks of the shard that the journal does not have yet. True if none of them is left.
bool run_study(const Study& study, const Shard& shard, Journal& journal, const StudyProgress& progress);

}  // namespace cairn
