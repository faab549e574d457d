// Floor 9. Journals of studies.
#include <cairn/study/journal.hpp>

#include <charconv>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/measure/whole_file.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/build_info.hpp>

namespace cairn {

namespace {

constexpr int most_shards = 10000;

bool read_count(std::string_view text, int& number) {
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && rest == text.data() + text.size();
}

std::string title_line(const std::string& study) { return "# " + study; }

/// Answers of two builds must not stand in one table.
std::string build_line() { return "# " + build_text(); }

/// Behind the answers of a study that has all of them.
constexpr const char* last_line = "# all done";

/// @throws std::invalid_argument for what is no file, std::runtime_error for one that cannot be read.
std::string text_of(const std::filesystem::path& path) {
  require(std::filesystem::is_regular_file(path), path.string(), "journal", "a file", "something else");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return all.str();
}

/// Lines that end with a line break: one that does not was cut off.
List<std::string> whole_lines(std::istream& in) {
  List<std::string> lines;
  for (std::string line; std::getline(in, line) && !in.eof();) lines.push_back(line);
  return lines;
}

}  // namespace

Shard parse_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  Shard shard;
  const bool is_pair = slash != std::string_view::npos && read_count(text.substr(0, slash), shard.number) &&
                       read_count(text.substr(slash + 1), shard.of);
  const bool holds = is_pair && shard.number >= 1 && shard.number <= shard.of && shard.of <= most_shards;
  require(holds, "shard", "part", "k/n with 1 <= k <= n <= " + std::to_string(most_shards), text);
  return shard;
}

Journal::Journal(std::filesystem::path path, const Study& study)
    : path_(std::move(path)), study_(study.name), tasks_(study.tasks.size()) {
  List<CsvCell> header = {std::string("task")};
  header.insert(header.end(), study.header.begin(), study.header.end());
  header_ = csv_line(header);
  if (std::filesystem::exists(path_) && !is_of_another_that_is_done(path_)) read(path_);
  rewrite();  // without the line that was cut off
}

std::string Journal::head() const { return title_line(study_) + '\n' + build_line() + '\n' + header_ + '\n'; }

bool Journal::is_of_another_that_is_done(const std::filesystem::path& path) const {
  const std::string text = text_of(path), end = '\n' + std::string(last_line) + '\n';
  return text.rfind("# ", 0) == 0 && text.rfind(head(), 0) != 0 && text.size() > end.size() &&
         text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void Journal::read(const std::filesystem::path& path) {
  const std::string text = text_of(path), ours = head();
  // It may have been cut off within its first three lines.
  const bool is_ours = text.compare(0, ours.size(), ours, 0, text.size()) == 0;
  const std::string first_line = text.substr(0, text.find('\n'));
  const bool is_titled = first_line.rfind("# ", 0) == 0;
  const bool has_title = first_line == title_line(study_);
  std::istringstream whole(text);
  const List<std::string> lines = whole_lines(whole);
  const std::string build = lines.size() > 1 ? lines[1] : "";
  require(is_ours || !has_title || build == build_line(), path.string(), "build", build_text(),
          build.rfind("# ", 0) == 0 ? build.substr(2) : "none");
  require(is_ours || !has_title, path.string(), "columns", "those of this version", "others");
  require(is_ours, path.string(), "journal", "of the study \"" + study_ + "\"",
          "\"" + first_line.substr(is_titled ? 2 : 0) + "\"");
  for (int i = 3; i < lines.size(); ++i) {
    if (lines[i] == last_line) continue;
    int task = -1;
    const bool is_task = read_count(std::string_view(lines[i]).substr(0, lines[i].find(',')), task);
    require(is_task && task >= 0 && task < tasks_, path.string(), "line " + std::to_string(i + 1),
            "begun by the number of one of the tasks", lines[i]);
    lines_.emplace(task, lines[i]);
  }
}

void Journal::write(int task, const List<CsvCell>& row) {
  List<CsvCell> cells = {static_cast<long long>(task)};
  cells.insert(cells.end(), row.begin(), row.end());
  const std::string line = csv_line(cells);
  std::ofstream out(path_, std::ios::app);
  lines_[task] = line;
  out << line << '\n' << (size() == tasks_ ? last_line + std::string("\n") : "");
  if (!out.flush()) throw std::runtime_error(path_.string() + ": cannot be written");
}

void Journal::absorb(const std::filesystem::path& other) {
  require(std::filesystem::exists(other), other.string(), "journal", "a file that exists", "none");
  read(other);
  rewrite();
}

void Journal::rewrite() const {
  const std::string end = size() == tasks_ ? last_line + std::string("\n") : "";
  write_whole_file(path_, title_line(study_) + '\n' + build_line() + '\n' + csv() + end);
}

std::string Journal::csv() const {
  std::string text = header_ + "\n";
  for (const auto& [task, line] : lines_) text += line + "\n";
  return text;
}

int tasks_in(const Study& study, const Shard& shard) {
  int count = 0;
  for (int task = 0; task < study.tasks.size(); ++task) count += shard.holds(task) ? 1 : 0;
  return count;
}

bool run_study(const Study& study, const Shard& shard, Journal& journal, const StudyProgress& progress) {
  List<int> waiting;
  for (int task = 0; task < study.tasks.size(); ++task) {
    if (shard.holds(task) && !journal.has(task)) waiting.push_back(task);
  }
  const int total = tasks_in(study, shard);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < waiting.size(); ++i) {
    journal.write(waiting[i], study.tasks[waiting[i]].run());
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    const double left =
        passed.count() / static_cast<double>(i + 1) * static_cast<double>(waiting.size() - i - 1);
    const bool goes_on = progress(total - (waiting.size() - i - 1), total, left);
    if (!goes_on && i + 1 < waiting.size()) return false;
  }
  return true;
}

}  // namespace cairn
