// What may stand in the gap of an exercise, right and wrong. answers.txt in the lesson's folder has it:
//
//     === the model: the first answer, which passes
//     body.velocity += acceleration * dt;
//     body.height += body.velocity * dt;
//
//     === moves the place first: any other fails, and a comment of the grader has the words
//     says: explicit Euler
//     body.height += body.velocity * dt;
//     body.velocity += acceleration * dt;
#pragma once

#include <string>

#include "math/list.hpp"

namespace cairn {

struct GapAnswer {
  std::string name = {};
  List<std::string> says = {};  // words that the grader's comments have on it; a wrong answer has some
  std::string code = {};
  int line = 0;  // of the file, where the code begins
};

/// The answers in the text of an answers.txt: the model, then the wrong ones. Throws std::runtime_error, with
/// the line, where there is no code or where words are missing.
List<GapAnswer> read_answers(const std::string& text);

/// The text of an exercise.cpp in three parts: what stands before the gap, in it and behind it. The lines
/// that mark the gap belong to the outer parts. Throws std::runtime_error where they are not there, once each
/// and in order.
struct GapText {
  std::string before = {};
  std::string gap = {};
  std::string behind = {};
};
GapText split_at_gap(const std::string& text);

}  // namespace cairn
