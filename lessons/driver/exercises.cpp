// Finds, grades and answers exercises.
#include "lessons/driver/exercises.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "lessons/answers.hpp"
#include "lessons/driver/process.hpp"
#include "scenes/data_folder.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;

}  // namespace

fs::path lessons_folder() {
  const fs::path folder = data_folder() / "lessons";
  if (!fs::exists(folder)) {
    throw std::runtime_error("the lessons' texts should be in " + folder.string() + ", which is not there");
  }
  return folder;
}

fs::path lesson_folder(const Program& lesson) {
  return lessons_folder() / lesson.name.substr(std::string("lesson").size());
}

std::optional<ExerciseFiles> exercise_of(const Program& lesson) {
  const std::string number = two_digits(lesson.number);
  const fs::path folder = lesson_folder(lesson);
  if (!fs::exists(folder / "exercise.cpp")) return std::nullopt;
  return ExerciseFiles{.program = lesson.path.parent_path() / ("exercise" + number),
                       .answers = folder / "answers.txt"};
}

int grade_exercise(const Program& lesson, const ExerciseFiles& files) {
  if (!fs::exists(files.program)) {
    fmt::print(stderr, "lessons: exercise {0} is not built; bash lessons/run check {0} builds it\n",
               lesson.number);
    return not_built;
  }
  return run_aloud({files.program.string()});
}

int show_solution(const Program& lesson, const ExerciseFiles& files) {
  std::ifstream stream(files.answers);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text.empty()) {
    fmt::print(stderr, "lessons: cannot read {}, the answer to exercise {}\n", files.answers.string(),
               lesson.number);
    return not_built;
  }
  fmt::print("{}", read_answers(text).front().code);
  return 0;
}

}  // namespace cairn::driver
