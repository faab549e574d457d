// The exercises that belong to lessons.
#pragma once

#include <filesystem>
#include <optional>

#include "lessons/driver/catalogue.hpp"

namespace cairn::driver {

/// What a lesson's folder and the folder of the programs have for its exercise.
struct ExerciseFiles {
  std::filesystem::path program = {};  // grades; may not have been built
  std::filesystem::path model = {};    // the model answer
};

/// Where the texts of the lessons are. @throws std::runtime_error where they are not there.
std::filesystem::path lessons_folder();
/// Where the text and the exercise of a lesson are. @throws as lessons_folder().
std::filesystem::path lesson_folder(const Program& lesson);

/// None for a lesson without an exercise.
std::optional<ExerciseFiles> exercise_of(const Program& lesson);

/// Grades the answer, aloud, under the limits of reader_code/run.hpp. The exit code: 0 if its grader has said
/// so, and not otherwise; 3 where the program has not been built.
int grade_exercise(const Program& lesson, const ExerciseFiles& files);

/// Shows a hint, under the same limits: the reader's code is part of the program. The exit code, as above.
int show_exercise_hint(const Program& lesson, const ExerciseFiles& files, const List<std::string>& number);

/// Prints the model answer.
int show_solution(const Program& lesson, const ExerciseFiles& files);

}  // namespace cairn::driver
