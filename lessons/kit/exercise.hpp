// The exercises: what is asked, and how an answer is graded. A lesson's folder has four files for its
// exercise:
//     exercise.cpp    what the reader edits: what the code needs, and one gap between the lines
//                         // Your code begins here: about five lines.
//                         // Your code ends here.
//     grade.cpp       includes exercise.cpp, calls what stands in it and returns exercise()
//     model.txt       the model answer: what stands in the gap when all is right
//     exercise.wrong  wrong answers, as edits of the model, with the words that the grader must say
// A test fills the gap with each of them: the model passes, and every other fails with its words.
#pragma once

#include <functional>
#include <string>

#include "lessons/kit/grading.hpp"
#include <cairn/math/list.hpp>

namespace cairn {

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

/// The text of an exercise.cpp in three parts: what stands before the gap, in it and behind it. The lines
/// that mark the gap belong to the outer parts.
struct GapText {
  std::string before = {};
  std::string gap = {};
  std::string behind = {};
};
/// @throws std::runtime_error where the lines that mark the gap are not there, once each and in order.
GapText split_at_gap(const std::string& text);

}  // namespace cairn
