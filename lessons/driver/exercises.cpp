// Finds, grades and answers exercises.
#include "lessons/driver/exercises.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "lessons/reader_code/run.hpp"
#include <cairn/scenes/data_folder.hpp>

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;

int run_exercise(const Program& lesson, const ExerciseFiles& files, const List<std::string>& words) {
  if (!fs::exists(files.program)) {
    fmt::print(stderr, "lessons: exercise {0} is not built; bash lessons/run check {0} builds it\n",
               lesson.number);
    return not_built;
  }
  reader_code::Job job = {.command = {files.program.string()}, .file = "exercise.cpp"};
  job.command.insert(job.command.end(), words.begin(), words.end());
  const reader_code::Ended ended = reader_code::run(job);
  if (!ended.words.empty() && ended.code == not_built) fmt::print(stderr, "lessons: {}\n", ended.words);
  if (!ended.words.empty() && ended.code != not_built) fmt::print("{}\n", ended.words);
  return ended.code;
}

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
                       .model = folder / "model.txt"};
}

int grade_exercise(const Program& lesson, const ExerciseFiles& files) {
  const int code = run_exercise(lesson, files, {});
  if (code == 0) fmt::print("Passed.\n");
  if (code == 1) fmt::print("Not yet. A hint: bash lessons/run hint {}\n", lesson.number);
  return code;
}

int show_exercise_hint(const Program& lesson, const ExerciseFiles& files, const List<std::string>& number) {
  List<std::string> words = {"--hint"};
  words.insert(words.end(), number.begin(), number.end());
  return run_exercise(lesson, files, words);
}

int show_solution(const Program& lesson, const ExerciseFiles& files) {
  std::ifstream stream(files.model);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text.empty()) {
    fmt::print(stderr, "lessons: cannot read {}, the answer to exercise {}\n", files.model.string(),
               lesson.number);
    return not_built;
  }
  fmt::print("{}", text);
  return 0;
}

}  // namespace cairn::driver
