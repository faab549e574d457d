// The exercises: what is asked, and how an answer is graded. A lesson's folder has three files for its
// exercise: exercise.cpp, which the reader edits: what the code needs, and one gap between the lines
//     // Your code begins here: about five lines.
//     // Your code ends here.
// grade.cpp, which includes exercise.cpp, calls what stands in it and returns exercise(); and answers.txt,
// which has the model answer and the wrong ones (lessons/answers.hpp shows its form). A test fills the gap
// with each of them: the model passes, and every other fails with the words that answers.txt names.
#pragma once

#include <functional>
#include <string>

#include "math/list.hpp"

namespace cairn {

/// A wrong number that gives away how it came about. Without words where another mark has them: what follows
/// from one mistake is no second one.
struct Misconception {
  double value = 0;       // that an answer gives which rests on it; may be infinite or NaN
  std::string what = {};  // "That is the force: an impulse is the force times dt."
};

/// One number that an answer has to give.
struct ExpectedNumber {
  std::string what = {};  // "impulse under the corner (N s)"
  double value = 0;
  double tolerance = 0;  // of the number and of every misconception, in its unit
  List<Misconception> misconceptions = {};
};

/// What came of a number.
struct Mark {
  std::string what = {};
  double expected = 0;
  double got = 0;
  bool holds = false;
  std::string comment = {};  // names the misconception, if the number gives one away
};

/// The marks of an answer.
class Grade {
 public:
  void number(const ExpectedNumber& expected, double got);

  const List<Mark>& marks() const { return marks_; }
  /// Whether there are marks, and all of them hold.
  bool passed() const;

 private:
  List<Mark> marks_;
};

struct Exercise {
  int lesson = 0;
  std::string task = {};                   // what to write, and where the equation stands
  std::string file = {};                   // that has the gap, from the project's folder
  List<std::string> hints = {};            // from vague to plain
  std::function<void(Grade&)> grade = {};  // asks the answer for its numbers
};

/// A program that grades one exercise: shows the marks, or a hint with --hint K. `source` is the file that it
/// was built from: where its gap is still empty, there is nothing to mark. Exit code 0: passed, 1: not yet,
/// 2: bad usage, 3: the output cannot be written. Whoever has started it hears the code as
/// reader_code/verdict.hpp has it, and says whether the exercise is passed.
int exercise_program(const Exercise& exercise, const std::string& source, int argument_count,
                     const char* const* arguments);

/// For each lesson: its exercise as it comes, then with each answer of its answers.txt. Made when the project
/// is built.
List<List<Exercise>> all_answers();

}  // namespace cairn
