// Grading, and the words around it.
#include "lessons/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "lessons/output.hpp"

namespace cairn {
namespace {

void print_marks(const Grade& grade) {
  for (const Mark& mark : grade.marks()) {
    const std::string numbers = mark.holds ? fmt::format("{:.6g}", mark.got)
                                           : fmt::format("{:.6g}, not {:.6g}", mark.got, mark.expected);
    fmt::print("CHECK  {:<58} {}  {}\n", mark.what, numbers, mark.holds ? "ok" : "no");
    if (!mark.comment.empty()) fmt::print("       {}\n", mark.comment);
  }
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

int run_exercise(const Exercise& exercise, int argument_count, const char* const* arguments) {
  if (argument_count > 1) {
    const bool is_hint = std::string_view(arguments[1]) == "--hint" && argument_count <= 3;
    if (is_hint) return show_hint(exercise, argument_count == 3 ? arguments[2] : "1");
    fmt::print(stderr, "exercise {:02}: unknown word {}; there is: --hint [1-{}]\n", exercise.lesson,
               arguments[1], exercise.hints.size());
    return 2;
  }
  Grade grade;
  exercise.grade(grade);
  fmt::print("EXERCISE {:02}  {}\n         {}\n", exercise.lesson, exercise.task, exercise.file);
  print_marks(grade);
  if (grade.passed()) {
    fmt::print("Passed.\n");
    return 0;
  }
  if (grade.is_empty()) fmt::print("Nothing was computed: the gap is still empty.\n");
  fmt::print("Not yet. A hint: bash lessons/run hint {}\n", exercise.lesson);
  return 1;
}

int finished(int code) {
  if (output_is_written()) return code;
  fmt::print(stderr, "exercise: the output cannot be written\n");
  return 3;
}

}  // namespace

void Grade::number(const ExpectedNumber& expected, double got) {
  Mark mark{.what = expected.what, .expected = expected.value, .got = got};
  mark.holds = std::abs(got - expected.value) <= expected.tolerance;  // a NaN holds nothing
  if (!mark.holds) {
    for (const Misconception& known : expected.misconceptions) {
      // Infinity less infinity is no number, and no number is equal to none.
      const bool is_it = got == known.value || (std::isnan(got) && std::isnan(known.value)) ||
                         std::abs(got - known.value) <= expected.tolerance;
      if (is_it && mark.comment.empty()) mark.comment = known.what;
    }
  }
  marks_.push_back(mark);
}

bool Grade::passed() const {
  return !marks_.empty() &&
         std::all_of(marks_.begin(), marks_.end(), [](const Mark& mark) { return mark.holds; });
}

bool Grade::is_empty() const {
  return std::all_of(marks_.begin(), marks_.end(), [](const Mark& mark) { return std::isnan(mark.got); });
}

int exercise_program(const Exercise& exercise, int argument_count, const char* const* arguments) {
  return finished(run_exercise(exercise, argument_count, arguments));
}

}  // namespace cairn
