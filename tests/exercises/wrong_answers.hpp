// What an exercise says of a wrong answer.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "lessons/exercise.hpp"

namespace cairn::testing {

/// All comments on an answer that must not pass.
inline std::string comments_of(const Grade& grade) {
  CHECK_FALSE(grade.passed());
  std::string all;
  for (const Mark& mark : grade.marks()) all += mark.comment + "\n";
  return all;
}

inline bool names(const Grade& grade, const std::string& misconception) {
  return comments_of(grade).find(misconception) != std::string::npos;
}

/// Whether `grade`, the grader of an exercise, says what is misunderstood in an answer.
template <auto grade, typename Answer>
bool tells(const Answer& answer, const std::string& misconception) {
  Grade marks;
  grade(marks, answer);
  return names(marks, misconception);
}

}  // namespace cairn::testing
