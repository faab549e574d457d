// What stands around the grading of an exercise.
#include "lessons/kit/exercise.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "lessons/kit/output.hpp"
#include "lessons/reader_code/verdict.hpp"

namespace cairn {
namespace {

constexpr std::string_view begin_mark = "// Your code begins here", end_mark = "// Your code ends here";

/// Where the line that has `mark` begins.
std::size_t marked_line(const std::string& text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos || text.find(mark, at + 1) != std::string::npos) {
    throw std::runtime_error(fmt::format("\"{}\" must stand in exactly one line", mark));
  }
  return text.rfind('\n', at) + 1;  // the first line: npos + 1 = 0
}

int show_hint(const Exercise& exercise, std::string_view word) {
  const int count = exercise.hints.size();
  const bool is_number = word.size() == 1 && word[0] >= '1' && word[0] <= '9';
  const int number = is_number ? word[0] - '0' : 0;
  if (number < 1 || number > count) {
    fmt::print(stderr, "exercise {:02}: --hint must be a whole number from 1 to {}, got {}\n",
               exercise.lesson, count, word);
    return 2;
  }
  fmt::print("Hint {} of {}: {}\n", number, count, exercise.hints[number - 1]);
  return 0;
}

/// Whether nothing but comments stands in the gap of this file.
bool has_empty_gap(const std::string& source) {
  std::ifstream stream(source);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    std::istringstream lines(split_at_gap(text).gap);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find_first_not_of(" \t\r");
      if (begin != std::string::npos && line.compare(begin, 2, "//") != 0) return false;
    }
    return true;
  } catch (const std::runtime_error&) {
    return false;  // its marks are gone, and what stands there is graded as it is
  }
}

int run_exercise(const Exercise& exercise, const std::string& source, int argument_count,
                 const char* const* arguments) {
  if (argument_count > 1) {
    const bool is_hint = std::string_view(arguments[1]) == "--hint" && argument_count <= 3;
    if (is_hint) return show_hint(exercise, argument_count == 3 ? arguments[2] : "1");
    fmt::print(stderr, "exercise {:02}: unknown word {}; there is: --hint [1-{}]\n", exercise.lesson,
               arguments[1], exercise.hints.size());
    return 2;
  }
  fmt::print("EXERCISE {:02}  {}\n         {}\n", exercise.lesson, exercise.task, exercise.file);
  if (has_empty_gap(source)) {
    fmt::print("The gap is still empty: your code goes between its two lines.\n");
  } else {
    Grade grade;
    exercise.grade(grade);
    if (grade.passed()) return 0;
  }
  return 1;
}

int finished(int code) {
  if (output_is_written()) return code;
  fmt::print(stderr, "exercise: the output cannot be written\n");
  return 3;
}

}  // namespace

GapText split_at_gap(const std::string& text) {
  const std::size_t begin = marked_line(text, begin_mark), end = marked_line(text, end_mark);
  if (begin > end) {
    throw std::runtime_error(fmt::format("\"{}\" must stand before \"{}\"", begin_mark, end_mark));
  }
  const std::size_t gap = text.find('\n', begin) + 1;
  return {text.substr(0, gap), text.substr(gap, end - gap), text.substr(end)};
}

int exercise_program(const Exercise& exercise, const std::string& source, int argument_count,
                     const char* const* arguments) {
  return reader_code::graded(
      [&] { return finished(run_exercise(exercise, source, argument_count, arguments)); });
}

}  // namespace cairn
